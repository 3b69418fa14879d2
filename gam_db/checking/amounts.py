"""Notes on amounts: rows that belong nowhere, calibration, the window."""

from gam_db.checking.look import Look
from gam_db.checking.note import Note, noted, whole
from gam_db.checking.proposal import BLOCKS, CYCLES, Proposal
from gam_db.checking.words import instant

PART = 0.1
"""Share of a machine's recording that a channel may lack at either end before it is said."""


def amounts(look: Look, proposal: Proposal) -> list[Note]:
    """Return the notes on amounts."""
    why = "; is the condition right?" * (look.source.where is not None)
    return [
        *_nameless(look),
        *([] if look.channels else whole("nothing", True, why=why)),
        *_partial(look),
        *_calibration(look),
        *_windows(look, proposal),
    ]


def _nameless(look: Look) -> list[Note]:
    found = {role: count for role, count in look.nameless.items() if count}
    if not found:
        return []
    counts = ", ".join(f"{count:,} without {role}" for role, count in found.items())
    return whole("nameless", True, found=counts, column=look.source.columns[next(iter(found))])


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
    since, until = (
        lambda found, edge=edge: instant(min(row[edge] for row in found), look.kind)
        for edge in ("first_tick", "last_tick")
    )
    return [*noted("begins_late", late, first=since), *noted("ends_early", early, last=until)]


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
    return [
        *noted("no_calibration", without, must=len(without) == len(held)),
        *noted("short_calibration", short, blocks=BLOCKS),
    ]


def _windows(look: Look, proposal: Proposal) -> list[Note]:
    """Too few samples for a window, and windows that hold too few cycles."""
    held = [row for row in look.channels if row["lowest"] is not None]
    short = [
        row
        for row in held
        if row["samples"] - row["calibration_samples"] < look.setting(row).window
        or row["samples"] - look.setting(row).span < look.setting(row).window
    ]
    cycling = [
        row for row in look.channels if CYCLES * (row["cycle_length"] or 0) > look.setting(row).window
    ]
    longest = max((row["cycle_length"] for row in cycling), default=0)
    enough = max(proposal.window, CYCLES * longest)
    return [
        *noted("short", short, must=len(short) == len(held)),
        *noted("short_window", cycling, cycles=CYCLES, enough=enough),
    ]
