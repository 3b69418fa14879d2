"""What is asked of a run, and what it says that it did."""

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, field

from gam_db.columns import name_of
from gam_db.stored.planning import Row
from gam_db.stored.state import State


@dataclass(frozen=True)
class Wanted:
    """What is asked of a run.

    Attributes:
        lookback: how far behind the newest bucket late rows are looked for, in the unit of time.
        append_only: what was read within the lookback is counted; else it is summed up, which costs more
            and tells a changed value, too. It is read again where that differs.
        park_after: see :mod:`gam_db.stored.planning`; None parks no channel.
        repair_from: score anew from this instant on; None for what the lookback asks for.
        until: read nothing newer; None for all there is.
        full: score everything anew.
        confirmed: score anew also what can then not be made again, since its rows have gone.
        everything: look at parked channels, and count calibration anew, without waiting for a day.
        chosen: tells by asset and channel which channels are scored.
        limit: most readings to work on at once; None for what memory allows.
    """

    lookback: int
    append_only: bool = False
    park_after: int | None = None
    repair_from: int | None = None
    until: int | None = None
    full: bool = False
    confirmed: bool = False
    everything: bool = False
    chosen: Callable[[str, str], bool] = lambda asset, channel: True
    limit: int | None = None


@dataclass
class Report:
    """What a run did, or would do.

    Attributes:
        channels: a row per channel that was read: asset, channel, first_bucket, buckets (new or written
            anew), read_from, read_to (integer time; None where nothing was read, since there is nothing
            new), rows_read, context_rows, context_expected.
        moved: of a source that is said to grow only: channels in which rows came late or went all the
            same, or of which that is not known, so that they were read again as far as lookback.
        gone: channels whose context has gone from the source, with the time from which they were read.
        parked: channels that were not read.
        unknown_channels: rows of today that belong to no calibrated channel, by (asset, channel).
        nameless: rows of today without asset or channel.
        undated: rows of the source without a time.
        ranges: of each query: earliest instant, channels, rows in the range.
    """

    channels: list[Row] = field(default_factory=list)
    moved: int = 0
    gone: dict[tuple[str, str], int] = field(default_factory=dict)
    parked: int = 0
    unknown_channels: dict[tuple[str, str], int] = field(default_factory=dict)
    nameless: int = 0
    undated: int = 0
    ranges: list[Row] = field(default_factory=list)

    def note_unknown(self, names: Sequence[Row], known: Container[tuple[str, str]]) -> None:
        """Note the readings of names that are missing, or of no known channel."""
        for row in names:
            if row["asset"] is None or row["channel"] is None:
                self.nameless += row["readings"] + row["without_time"]
            elif name_of(row) not in known and row["readings"]:
                self.unknown_channels[name_of(row)] = row["readings"]

    def keep_unplaced(self, state: State, monitor_id: int, started: int) -> None:
        """Append what a run gave to no channel or instant, if there was any."""
        found = {
            "nameless": self.nameless,
            "undated": self.undated,
            "strangers": sum(self.unknown_channels.values()),
            "stranger_channels": len(self.unknown_channels),
        }
        if any(found.values()):
            state.append_rows("unplaced", [{"monitor_id": monitor_id, "started": started, **found}])
