"""Notes on values: missing ones, constants, long standstills, few levels, counters."""

from collections.abc import Callable, Sequence

from gam_db.checking.look import Look, Row
from gam_db.checking.note import Note, noted, sentence, whole
from gam_db.checking.proposal import MOST_STILL
from gam_db.checking.words import extent, percent

LONG_STILL = 0.2
"""Share of the samples that one value holds without a break, above which it is said."""
FEW_VALUES = 10
"""Distinct values up to which a signal is a state rather than a measurement."""
EXACT_UP_TO = 2**53
"""Up to here each integer is a double."""
#: What is said of readings beyond that.
BEYOND = sentence("beyond")
_LEAST_RISES = 50
_FALLS_OF_COUNTER = 0.01


def values(look: Look) -> list[Note]:
    """Return the notes on values."""
    empty = [row for row in look.channels if row["lowest"] is None]
    held = [row for row in look.channels if row["lowest"] is not None]
    moving = [row for row in held if row["lowest"] < row["highest"]]
    constant = [row for row in held if row["lowest"] == row["highest"]]
    asleep = [
        row
        for row in moving
        if row["calibration_samples"]
        and row["calibration_lowest"] is not None
        and row["calibration_lowest"] == row["calibration_highest"]
    ]
    still = [
        row
        for row in moving
        if row["longest_still"] >= LONG_STILL * row["samples"] and not is_counter(row)
    ]
    # Still samples that take much of calibration, where somebody set that they do.
    left_out = [
        row
        for row in moving
        if look.setting(row).still_after is not None
        and row["calibration_still"] >= MOST_STILL * max(row["calibration_samples"], 1)
    ]
    coarse = [
        row
        for row in moving
        if row["values_seen"] > FEW_VALUES and (levels(row) or 2**31) < look.setting(row).grid
    ]
    value = getattr(look.source, "value", None)
    # Integers and decimals that are no doubles: neighbours become one.
    beyond = [
        row
        for row in held
        if (value or row["channel"]) in look.exact
        and max(abs(row["lowest"]), abs(row["highest"])) >= EXACT_UP_TO
    ]
    names = ", ".join(map(repr, look.number_texts))
    nowhere = len(empty) == len(look.channels)
    meaning = "; is it the right value column?" if nowhere else ": not assessable"
    return [
        *noted("empty", empty, must=nowhere, meaning=meaning),
        *noted(
            *("missing", [row for row in held if row["missing"]]),
            each=lambda found: " each" * (len(found) > 1),
            share=lambda found: (
                "at most " * (len(found) > 1)
                + percent(max(row["missing"] / row["samples"] for row in found))
            ),
        ),
        *noted("constant", constant, must=not moving, all="" if moving else "; nothing to watch"),
        *noted("constant_in_calibration", asleep),
        *noted("still", still, share=_share_of("longest_still", "samples")),
        *noted(
            *("still_after", left_out),
            share=_share_of("calibration_still", "calibration_samples"),
            longest=lambda found: f"{max(row['longest_run'] for row in found):,}",
        ),
        *noted("counter", [row for row in moving if is_counter(row)], resets=_resets),
        *noted("states", [row for row in moving if row["values_seen"] <= FEW_VALUES]),
        *noted(
            *("coarse", coarse),
            levels=lambda found: extent([levels(row) or 0 for row in found]),
            least=lambda found: min(levels(row) or 0 for row in found),
        ),
        *noted("beyond", beyond),
        *(whole("number_texts", names=names) if names else ()),
    ]


def is_counter(row: Row) -> bool:
    """Tell whether a channel only rises, but for a few falls back."""
    return bool(row["rises"] >= _LEAST_RISES and row["falls"] <= _FALLS_OF_COUNTER * row["rises"])


def levels(row: Row) -> int | None:
    """Return how many levels the resolution of a channel leaves in its range; None if it has none."""
    if row["quantum"] is None:
        return None
    count = (row["highest"] - row["lowest"]) / row["quantum"] + 1.5
    return int(count) if count < 2**31 else None


def _share_of(part: str, all_of_it: str) -> Callable[[Sequence[Row]], str]:
    """Return what says which share a column is of another one, from the least to the greatest."""

    def said(rows: Sequence[Row]) -> str:
        shares = [row[part] / row[all_of_it] for row in rows]
        least, most = percent(min(shares)), percent(max(shares))
        return least if least == most else f"{least.removesuffix(' %')} to {most}"

    return said


def _resets(rows: Sequence[Row]) -> str:
    falls = extent([row["falls"] for row in rows])
    return f", but for {falls} fall{'s' * (falls != '1')} (resets)" if falls != "0" else ""
