"""The request of a run, and its report."""

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, field

from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.reading.ahead import Clock
from gam_db.reading.undated import Undated
from gam_db.stored.planning import Row
from gam_db.stored.state import State


@dataclass(frozen=True)
class Wanted:
    """The request of a run.

    Attributes:
        lookback: how far behind the newest bucket late rows are looked for, in the unit of time.
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
    park_after: int | None = None
    repair_from: int | None = None
    until: int | None = None
    full: bool = False
    confirmed: bool = False
    everything: bool = False
    chosen: Callable[[str, str], bool] = lambda asset, channel: True
    limit: int | None = None

    @property
    def is_anew(self) -> bool:
        """Whether to write buckets anew even if nothing seems to have changed."""
        return self.full or self.repair_from is not None


@dataclass
class Report:
    """What a run did, or would do.

    Attributes:
        clock: of the database, as the run read it.
        channels: a row per channel that was read: asset, channel, first_bucket, buckets (new or written
            anew), read_from, read_to (integer time; None where nothing was read, since there is nothing
            new), rows_read, context_rows, context_expected.
        gone: channels whose context has gone from the source, with the time from which they were read.
        parked: channels that were not read.
        unknown_channels: readings (of today) and latest (their newest time) of channels that have no
            calibration, by (asset, channel).
        nameless: rows of today without asset or channel.
        undated: rows of the source without a time; ``skipped`` of them tell a local time that does not
            exist, between ``first_skipped`` and ``last_skipped``.
        ahead: a row per channel with rows that are later than now; see
            :func:`gam_db.reading.ahead.rows_ahead`. They were not read.
        invalid: readings for which ``valid_when`` does not hold, of the ``held`` ones that were read.
        ranges: of each query: earliest instant, channels, rows in the range.
    """

    clock: Clock
    channels: list[Row] = field(default_factory=list)
    gone: dict[tuple[str, str], int] = field(default_factory=dict)
    parked: int = 0
    unknown_channels: dict[tuple[str, str], Row] = field(default_factory=dict)
    nameless: int = 0
    undated: int = 0
    ahead: list[Row] = field(default_factory=list)
    skipped: int = 0
    first_skipped: int | None = None
    last_skipped: int | None = None
    held: int = 0
    invalid: int = 0
    ranges: list[Row] = field(default_factory=list)

    def note_unknown(self, names: Sequence[Row], channels: Container[tuple[str, str]]) -> None:
        """Note the readings of names that are missing, or of no known channel."""
        for row in names:
            if row["asset"] is None or row["channel"] is None:
                self.nameless += row["readings"] + row["without_time"]
            elif name_of(row) not in channels and row["readings"]:
                self.unknown_channels[name_of(row)] = {
                    name: row[name] for name in ("readings", "latest")
                }

    def note_undated(self, undated: Undated) -> None:
        """Note the rows that tell no time."""
        self.undated, self.skipped = undated.count, undated.skipped
        self.first_skipped, self.last_skipped = undated.first_skipped, undated.last_skipped

    def keep_unplaced(self, state: State, monitor: Row, started: int) -> None:
        """Append what a run gave to no channel or instant, and of which channels it left rows out."""
        counts = {
            "nameless": self.nameless,
            "undated": self.undated,
            "strangers": sum(row["readings"] for row in self.unknown_channels.values()),
            "stranger_channels": len(self.unknown_channels),
        }
        validity = {"held": self.held or None, "invalid": self.invalid if self.held else None}
        run = {"monitor_id": monitor["monitor_id"], "started": started}
        with state.session.transaction():
            state.append_rows("unplaced", [{**run, **counts, **validity}])
            if state.session.transactions:  # else pruning does it now and then
                before = {"monitor": template.text(monitor["name"])}
                expired = state.query("stored/pruning/expired_left_out", before)
                state.session.delete(state.tables.table("left_out"), expired.named_selects, expired)
            state.append_rows("left_out", [{**run, **row} for row in self.left_out])

    @property
    def left_out(self) -> list[Row]:
        """The channels of which rows were left out: kind, asset, channel, readings and latest."""
        ahead = [
            {
                "kind": "ahead",
                "asset": row["asset"],
                "channel": row["channel"],
                "readings": row["ahead_rows"],
                "latest": row["ahead_to"],
            }
            for row in self.ahead
        ]
        unknown = [
            {"kind": "unknown", "asset": asset, "channel": channel, **row}
            for (asset, channel), row in self.unknown_channels.items()
        ]
        return ahead + unknown
