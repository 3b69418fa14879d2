"""Visible rows are those of the newest finished run that reached a bucket."""

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from typing import Any

import duckdb
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gam_db.engines import engine_named
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables


@dataclass(frozen=True)
class Run:
    """Buckets from one on of one version, up to an end; perhaps cut short before its record.

    One that was withdrawn has a second row. One that counts may have deleted what it hides.
    """

    version: int
    start: int
    length: int
    is_finished: bool
    is_withdrawn: bool = False
    deletes: bool = False

    @property
    def buckets(self) -> range:
        """The numbers of its buckets."""
        return range(self.start, self.start + self.length)

    @property
    def counts(self) -> bool:
        """Whether it is seen."""
        return self.is_finished and not self.is_withdrawn


RUNS = st.lists(
    st.builds(
        Run,
        st.integers(1, 2),
        st.integers(0, 6),
        st.integers(0, 5),
        st.sampled_from([True, True, False]),
        st.sampled_from([False, False, True]),
        st.booleans(),
    ),
    max_size=8,
)


def expected(runs: Sequence[Run]) -> set[tuple[int, int, int]]:
    """Version, bucket and run of each visible row, by going through the runs one after another."""
    visible: dict[tuple[int, int], int] = {}
    for run_id, run in enumerate(runs, start=1):
        if run.counts:
            visible = {
                (version, bucket): by
                for (version, bucket), by in visible.items()
                if version != run.version or bucket < run.start
            }
            visible |= {(run.version, bucket): run_id for bucket in run.buckets}
    return {(version, bucket, by) for (version, bucket), by in visible.items()}


def left(runs: Sequence[Run]) -> list[tuple[int, int, int]]:
    """Version, bucket and run of each row that is there."""
    rows: list[tuple[int, int, int]] = []
    for run_id, run in enumerate(runs, start=1):
        if run.counts and run.deletes:
            rows = [row for row in rows if row[0] != run.version or row[1] < run.start]
        rows += [(run.version, bucket, run_id) for bucket in run.buckets]
    return rows


@pytest.fixture(scope="module")
def connections() -> Iterator[list[Any]]:
    """An engine that is the default, and one that shares no code with it."""
    with duckdb.connect() as duck, closing(sqlite3.connect(":memory:")) as lite:
        duck.execute(rendered(engine_named("duckdb"), StateTables()))
        lite.executescript(rendered(engine_named("sqlite"), StateTables()))
        yield [duck, lite]


def write(connection: Any, table: str, rows: list[str]) -> None:
    """Let a table hold these rows only."""
    connection.execute(f"DELETE FROM {table}")
    if rows:
        connection.execute(f"INSERT INTO {table} VALUES " + ", ".join(rows))


@given(runs=RUNS)
def test_the_newest_finished_run_that_reached_a_bucket_is_seen(
    connections: list[Any], runs: list[Run]
) -> None:
    numbered = list(enumerate(runs, start=1))
    keys = [f"{version}, {bucket}, {by}" for version, bucket, by in left(runs)]
    nothing = "0, 0, 0, 0, NULL, NULL, 0, NULL, NULL, NULL, 0, 0, 0"
    finished = [
        f"({by}, {run.version}, {run.start}, {nothing}, {withdrawn}, NULL, "
        f"{0 if run.counts and run.deletes else 'NULL'}, NULL, NULL)"
        for by, run in numbered
        for withdrawn in (("NULL", "1") if run.is_withdrawn else ("NULL",))
        if run.is_finished
    ]
    for connection in connections:
        write(
            connection,
            "gam_state_bucket",
            [f"({key}, 1, 2, 3, 4, 5, 6, NULL, NULL, NULL)" for key in keys],
        )
        write(connection, "gam_state_novel", [f"({key}, 7, 8, 9, 10)" for key in keys])
        unknown = [f"({key}, 'p', 8, 9, 10)" for key in keys]
        write(connection, "gam_state_unknown_program", unknown)
        write(connection, "gam_state_run", finished)
        for view, more in (
            ("bucket", (1, 2, 3, 4, 5, 6, None)),
            ("novel", (7, 8, 9, 10)),
            ("program", ("p", 8, 9, 10)),
        ):
            found = connection.execute(f"SELECT * FROM gam_state_visible_{view}").fetchall()
            assert sorted(row[:3] for row in found) == sorted(expected(runs))
            assert {row[3:] for row in found} <= {more}
