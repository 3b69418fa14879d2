"""Figures of episodes: their course, their states, and what a change of the whole signal explains.

This module owns the figures of an episode; :mod:`gam_db.alarms.advising` words them.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

from gam_db.alarms.advising import Advice, advise
from gam_db.composing import template

Row: TypeAlias = dict[str, Any]

#: Gives the rows of one file of ``sql/`` that reads state tables only.
Reads: TypeAlias = Callable[[str, Mapping[str, template.Slot]], list[Row]]

#: What changes of a whole signal are called, by their numbers (``sql/stored/alarms/moves.sql``).
MOVES = ("none", "shift", "scale", "both", "mirror")

#: What is counted of an episode since its onset, and of its first judgements that were read again.
COUNTED = (
    *("window_length", "judgements", "novel", "onset_novel", "early_novel", "highest_novel"),
    *("out_of_range", "states", "later_states"),
)
MOVED = (
    "reread_vectors",
    "reread_novel",
    "move",
    "factor",
    "displacement",
    "regained",
    "lost",
    "explains",
)


def figures(reads: Reads, monitor: str) -> dict[int, Row]:
    """Return the figures of the episodes of a monitor, by their numbers.

    Returns:
        Of each: window_length (vectors of a judgement), judgements (from its onset to its last open
        one), novel (vectors in them), onset_novel (in that of the onset), early_novel (the larger of
        that and the next), highest_novel (of one), out_of_range (novel ones with a sample outside the
        calibrated range), states and later_states (novel cells, and those first visited in the later
        half); and of its first five judgements, as far as they were read again: reread_vectors,
        reread_novel, move (none, shift, scale, both, mirror), factor, displacement, regained (novel
        vectors whose cells are healthy once the move is undone), lost (others whose cells are not),
        explains (1 where that is nine tenths of the novel ones, and at most a tenth of all is lost).
        What was pruned, or could not be computed, is None.
    """
    slots: dict[str, template.Slot] = {"monitor": template.text(monitor)}
    by_episode = {row["episode"]: row for row in reads("stored/alarms/alarm_figures", slots)}
    moves = {row["episode"]: row for row in reads("stored/alarms/alarm_moves", slots)}
    return {number: {**_counted(row), **_moved(moves.get(number))} for number, row in by_episode.items()}


def with_figures(rows: Sequence[Row], counted: Mapping[int, Row]) -> list[Row]:
    """Return episodes (rows of ``stored.alarms.labels.alarms``) with their figures."""
    nothing = dict.fromkeys((*COUNTED, *MOVED))
    return [{**row, **counted.get(row["episode"], nothing)} for row in rows]


def advice_of(rows: Sequence[Row]) -> dict[int, Advice | None]:
    """Return the advice on each episode, by its number: the advice on its incident.

    It is None for merged and withdrawn episodes. The rows are all episodes, with their figures.
    """
    incidents: dict[int | None, list[Row]] = {}
    for row in rows:
        incidents.setdefault(row["incident"], []).append(row)
    incidents.pop(None, None)
    advice = {incident: advise(members) for incident, members in incidents.items()}
    return {row["episode"]: advice.get(row["incident"]) for row in rows}


def _counted(row: Row) -> Row:
    return {name: row[name] for name in COUNTED}


def _moved(row: Row | None) -> Row:
    if row is None:
        return dict.fromkeys(MOVED)
    named = {"reread_vectors": row["vectors"], "reread_novel": row["novel"]}
    named["move"] = MOVES[row["move_no"]]
    return {**named, **{name: row[name] for name in MOVED if name not in named}}
