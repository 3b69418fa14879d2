"""Judging channels: the limit of the health indicator, and what is said of a channel by it.

The rule itself stands in ``sql/judgement/``; every form of the method takes it from there.
"""

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add
from gam_db.pipeline import Pipeline


def limit_slots(learnt: str, target_floor: exp.Expr) -> dict[str, template.Slot]:
    """Return the slots ``:hi_limit`` and ``:limit_reason``.

    Args:
        learnt: what the query calls the rows that hold verdict, floor and floor_max.
        target_floor: health indicator that a healthy machine may show.
    """
    said = {name: exp.column(name, table=learnt) for name in ("verdict", "floor", "floor_max")}
    return {
        "hi_limit": template.fill("judgement/hi_limit", {**said, "target_floor": target_floor}),
        "limit_reason": template.fill("judgement/limit_reason", {"verdict": said["verdict"]}),
    }


#: What a channel is judged by beside its verdict, where it is known.
_KNOWN = {"hi": "DOUBLE", "has_limit": "BIGINT", "raised": "VARCHAR", "asks": "BIGINT"}


def add_judged(steps: Pipeline, assessed: str = "assessed", name: str = "judged") -> None:
    """Add the step that judges channels.

    Args:
        steps: with the step *assessed*.
        assessed: its name; it has a row per channel, with verdict and hi_limit. Without hi nothing is
            scored yet; without has_limit, raised and asks there are no episodes.
        name: of the step.
    """
    columns = steps.steps[assessed].query.named_selects
    slots: dict[str, template.Slot] = {
        known: exp.column(known) if known in columns else exp.cast(exp.null(), of)
        for known, of in _KNOWN.items()
    }
    slots["columns"] = [exp.column(column) for column in columns]
    add(steps, "judgement/judged", slots, name, {"assessed": assessed})
