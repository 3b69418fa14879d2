"""Notes on values: missing ones, constants, long standstills, few levels, counters."""

from collections.abc import Sequence

from gam_db.checking.look import Look, Row
from gam_db.checking.note import Note, noted
from gam_db.checking.proposal import MOST_STILL
from gam_db.checking.words import extent, percent

LONG_STILL = 0.2
"""Share of the samples that one value holds without a break, above which it is said."""
FEW_VALUES = 10
"""Distinct values up to which a signal is a state rather than a measurement."""
EXACT_UP_TO = 2**53
#: What is said of readings beyond that.
BEYOND = (
    "integers or decimals beyond 2^53, which are rounded to doubles, so that neighbours become one "
    "level: subtract an offset in a view"
)
"""Up to here each integer is a double."""
_LEAST_RISES = 50
_FALLS_OF_COUNTER = 0.01


def values(look: Look) -> list[Note]:
    """Return the notes on values."""
    held = [row for row in look.channels if row["lowest"] is not None]
    moving = [row for row in held if row["lowest"] < row["highest"]]
    return [
        *_empty(look.channels),
        *_missing(held),
        *_constant(held, moving),
        *_still(moving),
        *_left_out(look, moving),
        *_counters(moving),
        *_states(moving),
        *_coarse(look, moving),
        *_beyond(look, held),
        *_texts(look),
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


def _empty(rows: Sequence[Row]) -> list[Note]:
    empty = [row for row in rows if row["lowest"] is None]
    everywhere = len(empty) == len(rows)
    return noted(
        "empty",
        empty,
        lambda found: (
            "no usable value (NULL, NaN, infinite or beyond 1e300)"
            + ("; is it the right value column?" if everywhere else ": not assessable")
        ),
        must=everywhere,
    )


def _missing(rows: Sequence[Row]) -> list[Note]:
    def text(found: Sequence[Row]) -> str:
        shares = [row["missing"] / row["samples"] for row in found]
        counts = extent([row["missing"] for row in found])
        most = ("at most " if len(found) > 1 else "") + percent(max(shares))
        each = " each" * (len(found) > 1)
        return (
            f"{counts} samples missing{each} ({most}; NULL, NaN, infinite or beyond 1e300): the vectors "
            "that hold one are left out"
        )

    return noted("missing", [row for row in rows if row["missing"]], text)


def _constant(rows: Sequence[Row], moving: Sequence[Row]) -> list[Note]:
    constant = [row for row in rows if row["lowest"] == row["highest"]]
    asleep = [
        row
        for row in moving
        if row["calibration_samples"] and row["calibration_lowest"] == row["calibration_highest"]
    ]
    return [
        *noted(
            "constant",
            constant,
            lambda found: "constant: never raises an alarm" + ("" if moving else "; nothing to watch"),
            must=not moving,
        ),
        *noted(
            "constant_in_calibration",
            [row for row in asleep if row["calibration_lowest"] is not None],
            lambda found: (
                "constant in calibration, moving elsewhere: not assessable; take a part for calibration "
                "in which it moves"
            ),
        ),
    ]


def _still(moving: Sequence[Row]) -> list[Note]:
    return noted(
        "still",
        [
            row
            for row in moving
            if row["longest_still"] >= LONG_STILL * row["samples"] and not is_counter(row)
        ],
        lambda found: (
            f"one and the same value for {_still_share(found)} of the recording at a stretch: a machine "
            "that stood still (leave it out by where=, or calibrate where it works), or a stuck sensor"
        ),
    )


def _left_out(look: Look, moving: Sequence[Row]) -> list[Note]:
    """Still samples that take much of calibration, where somebody set that they do."""

    def text(found: Sequence[Row]) -> str:
        shares = [row["calibration_still"] / row["calibration_samples"] for row in found]
        least, most = percent(min(shares)), percent(max(shares))
        share = least if least == most else f"{least.removesuffix(' %')} to {most}"
        runs = extent([row["still_runs"] for row in found])
        longest = max(row["longest_run"] for row in found)
        return (
            f"still_after leaves out {share} of calibration, in {runs} runs of at most {longest:,} "
            "samples: a machine that stands at night has few long ones, a coarse signal many short "
            "ones, and wants a larger still_after"
        )

    return noted(
        "still_after",
        [
            row
            for row in moving
            if look.setting(row).still_after is not None
            and row["calibration_still"] >= MOST_STILL * max(row["calibration_samples"], 1)
        ],
        text,
    )


def _still_share(rows: Sequence[Row]) -> str:
    shares = [row["longest_still"] / row["samples"] for row in rows]
    least, most = percent(min(shares)), percent(max(shares))
    return least if least == most else f"{least.removesuffix(' %')} to {most}"


def _counters(moving: Sequence[Row]) -> list[Note]:
    def text(found: Sequence[Row]) -> str:
        falls = extent([row["falls"] for row in found])
        resets = f", but for {falls} fall{'s' * (falls != '1')} (resets)" if falls != "0" else ""
        only = f"only ever rises{resets}"
        return (
            f"{only}: a counter? Each new value would be a new state; leave it out, or take its "
            "difference from sample to sample in a view"
        )

    return noted("counter", [row for row in moving if is_counter(row)], text)


def _states(moving: Sequence[Row]) -> list[Note]:
    return noted(
        "states",
        [row for row in moving if row["values_seen"] <= FEW_VALUES],
        lambda found: (
            f"only {extent([row['values_seen'] for row in found])} different values: a state or a "
            "switch rather than a measurement; it is watched as well as it can be"
        ),
    )


def _coarse(look: Look, moving: Sequence[Row]) -> list[Note]:
    def text(found: Sequence[Row]) -> str:
        least = min(levels(row) or 0 for row in found)
        return (
            f"resolution coarser than the grid ({extent([levels(row) or 0 for row in found])} levels): "
            f"--bins {least} loses nothing"
        )

    found = [
        row
        for row in moving
        if row["values_seen"] > FEW_VALUES and (levels(row) or 2**31) < look.setting(row).grid
    ]
    return noted("coarse", found, text)


def _beyond(look: Look, held: Sequence[Row]) -> list[Note]:
    """Integers and decimals that are no doubles: neighbours become one."""
    value = getattr(look.source, "value", None)
    return noted(
        "beyond",
        [
            row
            for row in held
            if (value or row["channel"]) in look.exact
            and max(abs(row["lowest"]), abs(row["highest"])) >= EXACT_UP_TO
        ],
        lambda _: BEYOND,
    )


def _texts(look: Look) -> list[Note]:
    if not look.number_texts:
        return []
    names = ", ".join(repr(name) for name in look.number_texts)
    return [
        Note(
            "number_texts",
            False,
            f"numbers kept as text, and not read: {names}; if one is a reading, cast it in a view: "
            "CAST(... AS DOUBLE)",
        )
    ]
