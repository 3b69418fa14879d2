"""The range of a support: of all calibration samples, or of all but a few far from the rest.

The latter (both sides, section 1) takes rounds. At work :class:`~gam_db.study.running.Running` makes
them as far as they drop anything; a script spells all of them out.
"""

from collections.abc import Mapping
from itertools import pairwise

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import union_of
from gam_db.method.adding import OfSet
from gam_db.method.slots import place_in
from gam_db.settings.parameters import ROBUST, Parameters

#: Rounds at most.
ROUNDS = 4

#: Pieces of a range in which samples are counted.
PIECES = 128

#: Columns of the samples left out of a range, and their values if none was.
DROPPED: Mapping[str, exp.Expr] = {
    **dict.fromkeys(("dropped_below", "dropped_above"), exp.cast(exp.Literal.number(0), "BIGINT")),
    **dict.fromkeys(("lowest_dropped", "highest_dropped"), exp.cast(exp.null(), "DOUBLE")),
}

_ROUND = ("support_id", "lo", "hi", "allowed", "dropped_below", "dropped_above")


def is_robust(setting: Parameters) -> bool:
    """Tell whether samples may be left out of a range."""
    return setting.range == ROBUST


def add_bounds(set_steps: OfSet, body: str = "range", readings: str = "readings") -> None:
    """Add the bounds of one set, after *calibrated*.

    Args:
        set_steps: the steps of the set.
        body: the folder of ``sql/`` by which calibration samples are counted in pieces of a range.
        readings: the step that holds the readings of calibration, for the census.
    """
    if not is_robust(set_steps.setting):
        none = [exp.alias_(value, name) for name, value in DROPPED.items()]
        set_steps.add("support/bounds", {"dropped": none, "carried": []})
        return
    rounds = [f"range_{number}" for number in range(ROUNDS + 1)]
    set_steps.add("range/whole", name=rounds[0])
    for number, (before, name) in enumerate(pairwise(rounds), start=1):
        tables = {"range_before": before, "readings": readings}
        set_steps.add(f"{body}/range_counts", {"piece": piece()}, counts_of(number), tables)
        set_steps.add("range/narrowed", name=name, tables={"range_counts": counts_of(number)})
        # Where a round drops nothing, no later one does.
        set_steps.steps.rounds[set_steps.named(name)] = [
            set_steps.named(later) for later in rounds[number + 1 :]
        ]
    set_steps.steps.add(
        set_steps.named("rounds"),
        union_of(set_steps.steps, [set_steps.named(name) for name in rounds], _ROUND),
        "Rounds: the range of each support before the first round and after each that drops samples.",
    )
    set_steps.add("range/ranged")
    dropped: list[exp.Expr] = []
    for name, nothing in DROPPED.items():
        of_column: dict[str, template.Slot] = {
            "column": exp.column(name, table="seen"),
            "nothing": nothing,
        }
        dropped.append(exp.alias_(template.fill("range/dropped", of_column), name))
    slots: dict[str, template.Slot] = {
        "dropped": dropped,
        "carried": [exp.column(name) for name in DROPPED],
    }
    set_steps.add("support/bounds", slots, tables={"calibrated": "ranged"})


def counts_of(number: int) -> str:
    """Return the step that counts the samples of a round."""
    return f"range_counts_{number}"


def piece() -> exp.Expr:
    """Return the number of the piece of a range that holds a sample."""
    return template.fill("range/piece", {"place": place_in(PIECES)})


def taught(setting: Parameters, condition: exp.Expr) -> exp.Expr:
    """Return whether calibration teaches a vector: a condition, and that it holds no sample left out."""
    if not is_robust(setting):
        return condition
    inside = template.fill("range/inside")
    return inside if condition == exp.true() else exp.and_(condition, inside)
