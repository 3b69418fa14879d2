"""Notes on amounts: rows that belong nowhere, calibration, the window."""

from collections.abc import Sequence

from gam_db.checking.look import Look, Row
from gam_db.checking.note import Note, noted
from gam_db.checking.proposal import BLOCKS, CYCLES, Proposal
from gam_db.checking.words import extent, instant

PART = 0.1
"""Share of a machine's recording that a channel may lack at either end before it is said."""


def amounts(look: Look, proposal: Proposal) -> list[Note]:
    """Return the notes on amounts."""
    return [
        *_nameless(look),
        *_none(look),
        *_partial(look),
        *_calibration(look),
        *_window(look),
        *_cycles(look, proposal),
    ]


def _nameless(look: Look) -> list[Note]:
    found = [f"{count:,} without {role}" for role, count in look.nameless.items() if count]
    if not found:
        return []
    columns = look.source.columns
    first = next(role for role, count in look.nameless.items() if count)
    return [
        Note(
            "nameless",
            True,
            f"rows that belong nowhere: {', '.join(found)} (NULL, or an infinite time), and gam run "
            f"refuses them; mend them, or leave them out by --where '\"{columns[first]}\" IS NOT NULL'",
        )
    ]


def _none(look: Look) -> list[Note]:
    if look.channels:
        return []
    why = "; is the condition right?" if look.source.where is not None else ""
    return [Note("nothing", True, f"no row has a name, a time and a place in a channel{why}")]


def _partial(look: Look) -> list[Note]:
    """Channels that say nothing for a good part of the time in which others of their asset do."""
    first: dict[str, int] = {}
    last: dict[str, int] = {}
    for row in look.channels:
        asset = row["asset"]
        first[asset] = min(first.get(asset, row["first_tick"]), row["first_tick"])
        last[asset] = max(last.get(asset, row["last_tick"]), row["last_tick"])
    late, early = [], []
    for row in look.channels:
        begin, end = first[row["asset"]], last[row["asset"]]
        if row["first_tick"] - begin > PART * (end - begin):
            late.append(row)
        if end - row["last_tick"] > PART * (end - begin):
            early.append(row)

    def since(found: Sequence[Row], edge: str) -> str:
        return instant(min(row[edge] for row in found), look.kind)

    return [
        *noted(
            "begins_late",
            late,
            lambda found: (
                f"begins long after the other channels of its machine ({since(found, 'first_tick')} at "
                "the earliest): a calibration from the first sample on lies elsewhere for it"
            ),
        ),
        *noted(
            "ends_early",
            early,
            lambda found: (
                f"ends long before the other channels of its machine ({since(found, 'last_tick')} at "
                "the earliest): a dead sensor, or one that was taken out?"
            ),
        ),
    ]


def _calibration(look: Look) -> list[Note]:
    if look.method.calibration.pools:  # what a channel lacks, its pool may have
        return []
    held = [row for row in look.channels if row["lowest"] is not None]
    without = [row for row in held if row["calibration_lowest"] is None]
    short = [
        row
        for row in held
        if row["calibration_lowest"] is not None
        and row["lowest"] < row["highest"]
        and row["calibration_samples"] < BLOCKS * look.setting(row).window
    ]
    everywhere = len(without) == len(held)
    return [
        *noted(
            "no_calibration",
            without,
            lambda found: (
                "no usable sample in calibration: say which part is healthy where there is data "
                "(--calibrate FROM/TO, --calibration-duration, --calibration-fraction)"
            ),
            must=everywhere,
        ),
        *noted(
            "short_calibration",
            short,
            lambda found: (
                f"calibration is shorter than {BLOCKS} windows ({_extent(found, 'calibration_samples')} "
                "samples): the certificate takes shorter blocks; a longer calibration or a shorter "
                "window is better"
            ),
        ),
    ]


def _window(look: Look) -> list[Note]:
    held = [row for row in look.channels if row["lowest"] is not None]
    short = [
        row
        for row in held
        if row["samples"] - row["calibration_samples"] < look.setting(row).window
        or row["samples"] - look.setting(row).span < look.setting(row).window
    ]
    everywhere = len(short) == len(held)
    return noted(
        "short",
        short,
        lambda found: (
            f"too few samples for a window beside calibration ({_extent(found, 'samples')} in all, "
            f"{_extent(found, 'calibration_samples')} of calibration): no indicator; take a shorter "
            "--window, or collect more"
        ),
        must=everywhere,
    )


def _cycles(look: Look, proposal: Proposal) -> list[Note]:
    def text(found: Sequence[Row]) -> str:
        longest = max(row["cycle_length"] for row in found)
        return (
            f"the window holds fewer than {CYCLES} cycles of about {_extent(found, 'cycle_length')} "
            f"samples; take --window {max(proposal.window, CYCLES * longest)} or more"
        )

    return noted(
        "short_window",
        [row for row in look.channels if CYCLES * (row["cycle_length"] or 0) > look.setting(row).window],
        text,
    )


def _extent(rows: Sequence[Row], column: str) -> str:
    return extent([row[column] for row in rows])
