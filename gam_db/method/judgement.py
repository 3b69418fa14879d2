"""Judging channels: the limit of the health indicator, and the status of a channel by it.

The rule itself stands in ``sql/judgement/``; every form of the method takes it from there.
"""

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import OfSet, add
from gam_db.method.resolved import Method


def limit_slots(target_floor: exp.Expr) -> dict[str, template.Slot]:
    """Return the slots ``:hi_limit`` and ``:limit_reason``, over the verdict and floors of *learnt*."""
    verdict = exp.column("verdict", table="learnt")
    limit = limit_of(target_floor)
    return {
        "hi_limit": template.fill("judgement/hi_limit", {"verdict": verdict, "limit": limit}),
        "limit_reason": template.fill("judgement/limit_reason", {"verdict": verdict}),
    }


def limit_of(target_floor: exp.Expr) -> exp.Expr:
    """Return the limit of the health indicator over the floors of *learnt*, whatever its verdict."""
    floors = {name: exp.column(name, table="learnt") for name in ("floor", "floor_max")}
    return template.fill("judgement/limit", {**floors, "target_floor": target_floor})


#: What a channel is judged by beside its verdict, where it is known.
_OPTIONAL = {"hi": "DOUBLE", "has_limit": "BIGINT", "raised": "VARCHAR", "asks": "BIGINT"}
_OPTIONAL |= {"label": "VARCHAR", "sure": "DOUBLE"}


def add_judged(steps: Pipeline, assessed: str = "assessed", name: str = "judged") -> None:
    """Add the step that judges channels, over one with a row per channel: verdict and hi_limit.

    Without hi nothing is scored yet; without has_limit, raised, label, sure and asks there are no
    episodes.
    """
    columns = steps.steps[assessed].query.named_selects
    slots: dict[str, template.Slot] = {
        column: exp.column(column) if column in columns else exp.cast(exp.null(), of)
        for column, of in _OPTIONAL.items()
    }
    slots["columns"] = [exp.column(column) for column in columns]
    add(steps, "judgement/judged", slots, name, {"assessed": assessed})


def add_stillness(steps: Pipeline, method: Method, codes: str) -> None:
    """Add the step *stillness* of some codes: which channels stand still at their begin and end."""
    numbers = [n for n, setting in enumerate(method.settings) if setting.still_after is not None]
    for number in numbers:
        set_steps = OfSet(steps, method, number)
        tables = {"cohort": "bounds", "moving_codes": codes}
        set_steps.add("stored/scoring/stillness", {"long_ago": LONG_AGO}, tables=tables)
    if not numbers:
        add(steps, "stored/scoring/no_stillness", name="stillness", tables={"cohort": "channels"})
    elif len(method.settings) > 1:
        parts = [method.named("stillness", number) for number in numbers]
        rows = union_of(steps, parts, ("channel_id", "still_since"))
        steps.add("stillness", rows, template.load("stored/scoring/stillness").comment)


def add_standing(steps: Pipeline) -> None:
    """Add the step *standing*, over *judged*: which channels stand still at their end, too."""
    judged_names = steps.steps["judged"].query.named_selects
    names = [name for name in judged_names if name not in ("status", "is_above")]
    columns = [exp.column(name, table="judged").as_(name) for name in names]
    add(steps, "judgement/standing", {"columns": columns})
