"""State by hand: rows of state tables for tests, and what must be seen of them.

The rules of visibility and of the window are written here once more, over plain lists, and share no code
with the package.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.schema import migrations
from gam_db.stored.schema.tables import TABLES, StateTables

Row = dict[str, Any]

#: Steps between two vectors, in time.
STEP = 1_000_000

NEVER = -(2**62)


def emptied(session: DuckSession, tables: StateTables) -> DuckSession:
    """Take all rows out of the state tables, but the record of how they were made."""
    migrations.migrate(session, tables)
    for name in TABLES:
        if name != "migration":
            session.execute(exp.Delete(this=tables.table(name)))
    return session


@dataclass
class Version:
    """A version and the buckets that must be visible of it: (novel, run, cells) each, from 0."""

    version_id: int
    window: int
    stride: int
    start: int
    buckets: list[tuple[int, int, dict[int, int]]] = field(default_factory=list)

    def in_window(self, bucket: int) -> int | None:
        """Novel vectors in the window that ends with a bucket; None before there is one."""
        length = self.window // self.stride
        if bucket + 1 < length:
            return None
        return sum(novel for novel, _, _ in self.buckets[bucket + 1 - length : bucket + 1])

    def first_time(self, bucket: int) -> int:
        """Time of the first vector of a bucket."""
        return self.start + bucket * self.stride * STEP

    def last_time(self, bucket: int) -> int:
        """Time of its last vector."""
        return self.start + ((bucket + 1) * self.stride - 1) * STEP


@dataclass
class Plant:
    """State tables to be written: one list of rows each."""

    tables: dict[str, list[Row]] = field(default_factory=dict)
    ids: int = 0

    def add(self, table: str, **row: Any) -> None:
        """Note a row of a table."""
        self.tables.setdefault(table, []).append(row)

    def next_id(self) -> int:
        """A key above all before."""
        self.ids += 1
        return self.ids

    def monitor(self, name: str = "default", time_kind: str = "timestamp") -> int:
        """Note a monitor and return its key."""
        key = self.next_id()
        read = {"source": "t", "layout": "long", "time_column": "time"}
        self.add("monitor", monitor_id=key, name=name, time_kind=time_kind, created=0, **read)
        return key

    def channel(self, monitor: int, asset: str, channel: str) -> int:
        """Note a channel and return its key."""
        key = self.next_id()
        self.add("channel", channel_id=key, monitor_id=monitor, asset=asset, channel=channel)
        return key

    def support(
        self, verdict: str = "ready", floor: float | None = 0.01, cells: Iterable[int] = (), **more: Any
    ) -> int:
        """Note what was learnt and return its key."""
        key = self.next_id()
        learnt = {
            "calibrated_lo": None if floor is None else 0.0,
            "calibrated_hi": None if floor is None else 1.0,
            "dropped_below": 0,
            "dropped_above": 0,
            "calibration_vectors": 1000,
            "cells": 10,
            "seen_once": 1,
            "blocks": 10,
            "floor": floor,
            "floor_sd": floor,
            "floor_max": None if floor is None else 2.5 * floor,
            "finest_bins": 50,
            "vectors_needed": 0,
        }
        self.add("bounds", support_id=key, verdict=verdict, **{**learnt, **more})
        for cell in cells:
            self.add(
                "support",
                support_id=key,
                cell_key=cell,
                visits=1,
                first_block=0,
                last_block=0,
                first_time=0,
                last_time=0,
            )
        return key

    def version(
        self,
        channel: int,
        support: int,
        number: int = 1,
        window: int = 20,
        stride: int = 10,
        start: int = 0,
        **more: Any,
    ) -> Version:
        """Note a version; a later one of the same channel replaces it."""
        key = self.next_id()
        frozen = {
            "parent_id": None,
            "status": "active",
            "reason": "first calibration",
            "m": 2,
            "tau": 1,
            "bins": 10,
            "max_gap": None,
            "score_from": None,
            "target_floor": 0.05,
            "is_robust": 1,
            "calibration_end": start,
            "first_scored": start,
            "run_up_from": NEVER,
            "calibration_readings": 1000,
            "calibration_samples": 1000,
            "settings_hash": "s",
            "method_hash": "m",
            "created": 0,
        }
        self.add(
            "version",
            version_id=key,
            channel_id=channel,
            support_id=support,
            version_no=number,
            window_length=window,
            stride=stride,
            **{**frozen, **more},
        )
        self.add("calibration", version_id=key, time_from=NEVER, time_to=start)
        return Version(key, window, stride, start)

    def run(
        self,
        version: Version,
        cells: Sequence[dict[int, int]],
        from_bucket: int = 0,
        committed: bool = True,
        **more: Any,
    ) -> int:
        """Note the rows of a run that writes buckets from one on, each with its novel cells; its key."""
        run = self.next_id()
        shown = version.buckets
        kept = shown[:from_bucket]
        made = [(sum(visits.values()), run, visits) for visits in cells]
        version.buckets = kept + made
        for bucket, (novel, _, visits) in enumerate(made, start=from_bucket):
            times = {"first_time": version.first_time(bucket), "last_time": version.last_time(bucket)}
            own = {"version_id": version.version_id, "bucket_no": bucket, "run_id": run, **times}
            self.add(
                "bucket",
                **own,
                context_time=times["last_time"],
                samples=version.stride,
                novel=novel,
                out_of_range=novel // 2,
                novel_in_window=version.in_window(bucket),
            )
            for cell, count in visits.items():
                self.add("novel", **own, cell_key=cell, visits=count)
        if not committed:
            version.buckets = shown
            return run
        finished = {
            "read_from": version.first_time(from_bucket) - STEP,
            "read_to": version.last_time(len(version.buckets) - 1) if version.buckets else None,
            "rows_read": 100,
            "context_rows": 1,
            "context_expected": 1 if from_bucket else None,
            "calibration_readings": None,
            "settled_bucket": None,
            "lookback": 0,
            "started": 0,
            "committed": run,
        }
        self.add(
            "run",
            run_id=run,
            version_id=version.version_id,
            from_bucket=from_bucket,
            **{**finished, **more},
        )
        return run

    def write(self, session: DuckSession, tables: StateTables) -> None:
        """Append the rows to the tables, which are made if they are not there."""
        migrations.migrate(session, tables)
        for name, rows in self.tables.items():
            target = tables.table(name)
            columns = session.describe(target)
            given = [column for column in columns if column in rows[0]]
            loaded = session.load(pa.Table.from_pylist(rows))
            session.execute(
                exp.Insert(
                    this=exp.Schema(this=target, expressions=[exp.to_identifier(one) for one in given]),
                    expression=exp.select(*given).from_(loaded),
                )
            )
            session.forget(loaded)
        self.tables = {}
