"""Advice: a sentence on the figures of an episode, and a sentence on what to do next.

No cause is named: on simulated machines names of causes were right in 56 % of cases. The one exception
is a signal that moved as a whole, where that explains nine tenths of the novelty. This module owns the
sentences; the figures come from SQL.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from gam_db.data import table

#: Judgements below which a step and growth look the same.
FEWEST_JUDGEMENTS = 4

#: How near a factor must be to one that has a name, or to 1 to be none.
_NEAR = 0.03

_WORDS = table("gam_db.alarms", "advice.toml")


class Advice(NamedTuple):
    """A finding, and what to do next; a sentence each."""

    finding: str
    advice: str


class Signs(NamedTuple):
    """Signs derived from the figures of one episode; None where the figures do not decide.

    Attributes:
        course: step, growth, short, or pruned.
        place: outside, partly or inside the calibrated range.
        reach: exploring, where a fourth of the new states or more came in the later half, or settled.
        is_moved: whether a change of the whole signal explains the novelty.
    """

    course: str
    place: str | None
    reach: str | None
    is_moved: bool


def signs_of(row: Mapping[str, Any]) -> Signs:
    """Return the signs of the figures of one episode."""
    novel, highest = row["novel"], row["highest_novel"]
    course, place, reach = "pruned", None, None
    if highest is not None:
        course = "step" if 2 * row["early_novel"] >= highest else "growth"
        if row["judgements"] < FEWEST_JUDGEMENTS:
            course = "short"
    if novel and row["out_of_range"] is not None:
        outside = row["out_of_range"]
        place = "outside" if 2 * outside > novel else "partly" if 10 * outside >= novel else "inside"
    if row["states"] and course in ("step", "growth"):
        reach = "exploring" if 4 * row["later_states"] >= row["states"] else "settled"
    return Signs(course, place, reach, row["explains"] == 1)


def advise(rows: Sequence[Mapping[str, Any]]) -> Advice:
    """Return the advice on related episodes of one machine, or on a single one.

    Args:
        rows: at least one; each a row of episodes (gam_db/stored/alarms) with its figures.
    """
    strongest = max(rows, key=lambda row: row["sure"] or 0.0)  # an indicator has no evidence
    signs, signals = signs_of(strongest), len({row["channel_id"] for row in rows})
    finding = _WORDS["finding"]
    sentence = _finding(strongest, signs)
    if signals > 1:
        how = "at_once" if len({row["opened"] for row in rows}) == 1 else "several"
        sentence = finding[how].format(signals=signals, channel=strongest["channel"], alone=sentence)
    elif (signals := strongest["signals_together"]) > 1:
        sentence = finding["of_several"].format(signals=signals, alone=sentence)
    if any(row["status"] == "proving" for row in rows):
        which = "proving"
    elif signals > 1 and not signs.is_moved:
        which = "several"
    else:
        which = _advice(signs)
    advice = _WORDS["advice"][which].format(channel=strongest["channel"])
    return Advice(f"{sentence[0].upper()}{sentence[1:]}.", advice)


def _advice(signs: Signs) -> str:
    if signs.is_moved:
        return "moved"
    if signs.place == "outside":
        return "outside"
    return "exploring" if signs.reach == "exploring" else signs.course


def _finding(row: Mapping[str, Any], signs: Signs) -> str:
    words = _WORDS["finding"]
    if signs.is_moved:
        explained = _share(row["regained"], row["reread_novel"])
        return str(words["moved"].format(move=_move(row), explained=explained))
    parts = [words[part] for part in (signs.course, signs.place, signs.reach) if part is not None]
    shares = {}
    if signs.course != "pruned":
        window = row["window_length"]
        shares = {"early": _share(row["early_novel"], window)}
        shares["highest"] = _share(row["highest_novel"], window)
    if signs.place is not None:
        outside = row["out_of_range"]
        shares["outside"] = _share(outside, row["novel"])
        shares["inside"] = _share(row["novel"] - outside, row["novel"])
    return "".join(parts).format(**{**row, **shares})


def _move(row: Mapping[str, Any]) -> str:
    """Return how the signal moved as a whole, in its own units."""
    words, factor, by = _WORDS["move"], abs(row["factor"]), row["displacement"]
    distance = {"distance": abs(by), "side": "higher" if by >= 0 else "lower"}
    is_mirror, is_whole = row["factor"] < 0, abs(factor - 1) < _NEAR
    if is_whole and not is_mirror and by:
        return str(words["shift"].format(**distance))
    named = (name for of, name in _WORDS["times"].items() if abs(factor / float(of) - 1) < _NEAR)
    times = next(named, words["times"].format(factor=factor))
    if is_mirror:
        times = "" if is_whole else words["mirrored_times"].format(times=times)
    shown_by = words["by"].format(**distance) if by else ""
    return str(words["mirror" if is_mirror else "scale"].format(times=times, by=shown_by))


def _share(part: int, of: int) -> str:
    return f"{100 * part / of:.0f} %"


def promise(rows: Sequence[Mapping[str, Any]], episodes: int) -> str | None:
    """Return what the stated rate means for so many episodes; None where there are none, or no limits.

    Args:
        rows: limits with the number of their judgements (``sql/report/promises.sql``).
        episodes: raised so far, neither merged nor withdrawn.
    """
    stated = [row for row in rows if row["stated_rate"] is not None]
    words, rates = _WORDS["promise"], "; ".join(sorted({row["asked"] for row in rows}))
    if not rows or not episodes:
        return None
    if not stated:
        return str(words["unstated"].format(asked=rates))
    judgements = sum(row["judgements"] for row in stated)
    expected = sum(row["stated_rate"] * row["judgements"] for row in stated)
    counts = {"expected": "one" if expected < 1.5 else f"{expected:,.0f}", "episodes": episodes}
    means = words["many" if expected >= 0.5 else "none"].format(**counts)
    per_thousand = 1000 * expected / judgements
    return str(
        words["stated"].format(asked=rates, stated=per_thousand, judgements=judgements, means=means)
    )
