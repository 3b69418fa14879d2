"""The product's tables of several fleets, put together and judged by the product's own steps."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc

from gam_db.alarms import FROZEN, Alarms, chosen_limits
from gam_db.clock import TimeKind
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method.alarms import (
    add_backtested,
    add_judged,
    add_judgements,
    add_learnt_limits,
    add_replay,
    add_spreads,
)
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource
from gam_db.study import Study
from gam_db.study.running import Running

Name = tuple[str, str]
Row = dict[str, Any]

_TABLES = (
    *("channels", "limited", "bounds", "order_ratios", "lengths", "block_sizes", "buffered"),
    "judged_windows",
)
_APART = 1_000_000  # channel ids of one fleet from those of the next


@dataclass(frozen=True)
class Learnt:
    """What the product learnt and counted of one source: tables of its steps, by their names."""

    kind: TimeKind
    tables: dict[str, pa.Table]


def learnt(
    source: AnySource, parameters: Parameters, calibration: Calibration, more: Sequence[str] = ()
) -> Learnt:
    """Read a source; return its tables up to the counts of judged windows, and those of more steps."""
    with DuckSession() as session:
        study = Study(session, source, parameters, calibration)
        add_learnt_limits(study.steps, study.method, ())
        add_judgements(study.steps, study.method, study.instant_of)
        return Learnt(study.method.kind, {name: study.table(name) for name in (*_TABLES, *more)})


@dataclass(frozen=True)
class Judged:
    """What the product says at one asked rate.

    Attributes:
        rate: the rate, in words.
        limits: as :func:`gam_db.alarms.limits_of` returns them.
        counted: judgements and episodes of each channel with a limit (the step *backtested*).
        episodes: as :func:`gam_db.episodes` returns them, instants as integers.
    """

    rate: str
    limits: list[Row]
    counted: list[Row]
    episodes: list[Row]


class Pool:
    """Fleets that are judged together.

    Args:
        session: an open session.
        fleets: their tables; no two channels have one name.
    """

    def __init__(self, session: DuckSession, fleets: Sequence[Learnt]) -> None:
        self._session, self._kind = session, fleets[0].kind
        self._loaded = Running(session, Pipeline())
        self.tables = {}
        for name in _TABLES:
            parts = [_numbered(fleet.tables[name], k) for k, fleet in enumerate(fleets)]
            self.tables[name] = pa.concat_tables(parts)
            self._loaded.load(name, self.tables[name])

    def judged(self, alarms: Alarms) -> Judged:
        """Return what the product says at a rate, with the families that are asked for."""
        steps = Pipeline()
        add_spreads(steps, alarms.family)
        with Running(self._session, steps, self._loaded.tables) as work:
            rows = chosen_limits(work, alarms, self._kind)
            frozen = [row for row in rows if row["reason"] is None]
            work.load("frozen_limits", pa.Table.from_pylist(frozen, schema=FROZEN))
            add_judged(steps, lambda node: node)
            add_backtested(steps, ())
            counted, episodes = (work.rows(name) for name in ("backtested", "episodes"))
            unknown: Row = dict.fromkeys(("basis", "quarters", "stated_rate"))  # where there is no limit
            return Judged(
                alarms.rate_for(self._kind), [unknown | row for row in rows], counted, episodes
            )

    def replayed(self, roots: pa.Table, quarters: Sequence[int]) -> pa.Table:
        """Return what any series opens under the product's evidence, at several heights.

        Args:
            roots: channel_id, block (the judgement), root (in thousandths of a spread above the
                centre), family_no, blocks.
            quarters: heights, in quarters of a spread.

        Returns:
            One row per episode: channel_id, limit_no (the height), first_judgement, last_judgement.
        """
        steps = Pipeline()
        add_replay(steps)
        running = Running(self._session, steps)
        running.load("left_out", roots)
        running.load("heights", pa.table({"quarters": pa.array(quarters, pa.int64())}))
        try:
            return running.table("merged_replay")
        finally:
            running.forget()

    def merged(self, opened: Sequence[tuple[int, int]]) -> list[Row]:
        """Return the episodes of judgements that are open: pairs of channel_id and judgement_no."""
        steps = Pipeline()
        add_judged(steps, lambda node: node)
        names = ("channel_id", "judgement_no", "limit_no", "last_zero", "is_open")
        rows = [dict(zip(names, (*pair, 0, 0, 1), strict=True)) for pair in opened]
        running = Running(self._session, steps)
        running.load("opened", pa.Table.from_pylist(rows, pa.schema([(n, pa.int64()) for n in names])))
        try:
            merged: list[Row] = running.table("merged").to_pylist()
            return merged
        finally:
            running.forget()


def _numbered(rows: pa.Table, fleet: int) -> pa.Table:
    place = rows.column_names.index("channel_id")
    ids = pc.add(rows["channel_id"], fleet * _APART)
    return rows.set_column(place, "channel_id", ids)


def name_of(row: Row) -> Name:
    """Return what a row is about."""
    return row["asset"], row["channel"]
