"""The views: what BI tools read holds the visible rows of active versions, and nothing else."""

import contextlib
import datetime as dt
import json
import sqlite3
from collections import Counter
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gam_db.engines import engine_named
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import TABLES as ALL
from gam_db.stored.schema.tables import StateTables
from state_names import called
from stored_rows import STEP, Plant, Version, emptied

TABLES = StateTables(schema='the "state"', prefix="Odd_")
ODD = StateTables('"the ""state"""', "Odd_").shown
NAMES = ("R1", "r1", "it's", 'a "quoted" name', "Ünï %_\n", "")


@pytest.fixture(scope="module")
def session() -> Iterator[DuckSession]:
    """A database with state tables; each test takes out the rows of the one before."""
    with DuckSession() as opened:
        yield opened


def shown(session: DuckSession, view: str) -> list[dict[str, Any]]:
    """The rows of a view."""
    query = f"SELECT * FROM {ODD(view)} ORDER BY ALL"
    rows: list[dict[str, Any]] = session.connection.sql(query).to_arrow_table().to_pylist()
    return rows


@st.composite
def plants(draw: st.DrawFn) -> tuple[Plant, list[tuple[str, str, str, int, Version]]]:
    """State of two monitors, and of each channel its active version: monitor, asset, channel, number."""
    plant = Plant()
    active = []
    for monitor, kind in (("default", "timestamp with time zone"), ("it's", "counter")):
        monitor_id = plant.monitor(monitor, kind)
        names = st.tuples(st.sampled_from(NAMES), st.sampled_from(NAMES))
        for asset, channel in draw(st.lists(names, min_size=1, max_size=2, unique=True)):
            channel_id = plant.channel(monitor_id, asset, channel)
            support_id = plant.support()
            for number in range(1, draw(st.integers(1, 2)) + 1):
                stride = draw(st.integers(1, 2))
                version = plant.version(
                    channel_id,
                    support_id,
                    number,
                    window=stride * draw(st.integers(1, 3)),
                    stride=stride,
                    start=draw(st.integers(-100, 100)) * STEP,
                )
                for _ in range(draw(st.integers(0, 4))):
                    cells = st.dictionaries(st.integers(0, 3), st.integers(1, 2), max_size=2)
                    plant.run(
                        version,
                        draw(st.lists(cells, max_size=5)),
                        draw(st.integers(0, len(version.buckets))),
                        committed=draw(st.booleans()),
                    )
            active.append((monitor, asset, channel, number, version))
    return plant, active


def instant(tick: int, monitor: str) -> dt.datetime | None:
    """The time of a tick in a view; None where the monitor counts."""
    if monitor != "default":
        return None
    return dt.datetime(1970, 1, 1) + dt.timedelta(microseconds=tick)


@given(drawn=plants())
@settings(max_examples=20)
def test_the_views_show_what_finished_runs_left(
    session: DuckSession, drawn: tuple[Plant, list[tuple[str, str, str, int, Version]]]
) -> None:
    plant, active = drawn
    health, quarantine, fleet = [], [], []
    for monitor, asset, channel, number, version in active:
        name = {"monitor": monitor, "asset": asset, "channel": channel, "version_no": number}
        visits: Counter[int] = Counter()
        where: dict[int, list[int]] = {}
        for bucket, (novel, _, cells) in enumerate(version.buckets):
            in_window = version.in_window(bucket)
            ticks = (version.first_time(bucket), version.last_time(bucket))
            health.append(
                {
                    **name,
                    "bucket": bucket,
                    "first_time": instant(ticks[0], monitor),
                    "last_time": instant(ticks[1], monitor),
                    "first_tick": ticks[0],
                    "last_tick": ticks[1],
                    "samples": version.stride,
                    "novel": novel,
                    "out_of_range": novel // 2,
                    "novel_in_window": in_window,
                    "window_length": version.window,
                    "hi": None if in_window is None else in_window / version.window,
                }
            )
            visits.update(cells)
            for cell in cells:
                where.setdefault(cell, []).append(bucket)
        for cell, count in visits.items():
            ticks = (version.first_time(where[cell][0]), version.last_time(where[cell][-1]))
            quarantine.append(
                {
                    **name,
                    "cell_key": cell,
                    "visits": count,
                    "buckets": len(where[cell]),
                    "first_time": instant(ticks[0], monitor),
                    "last_time": instant(ticks[1], monitor),
                    "first_tick": ticks[0],
                    "last_tick": ticks[1],
                }
            )
        last = len(version.buckets) - 1
        before = last - version.window // version.stride
        counts = [version.in_window(bucket) for bucket in range(last + 1)]
        novel_now = counts[-1] if counts else None
        most = max((count for count in counts if count is not None), default=None)
        recent = version.buckets[before + 1 if before >= 0 else 0 :]
        fleet.append(
            {
                **name,
                "hi": None if novel_now is None else novel_now / version.window,
                "hi_highest": None if most is None else most / version.window,
                "novel_in_window": novel_now,
                "novel_window_before": counts[before] if before >= 0 else None,
                "out_of_range_in_window": sum(novel // 2 for novel, _, _ in recent) if counts else None,
                "bucket": last if counts else None,
                "buckets": len(counts),
                "novel_in_buckets": sum(novel for novel, _, _ in version.buckets),
                "last_tick": version.last_time(last) if counts else None,
                "last_time": instant(version.last_time(last), monitor) if counts else None,
            }
        )
    plant.write(emptied(session, TABLES), TABLES)

    def ordered(rows: list[dict[str, Any]], *by: str) -> list[dict[str, Any]]:
        return sorted(rows, key=lambda row: [row[key] for key in ("monitor", "asset", "channel", *by)])

    seen = ordered(shown(session, "health"), "bucket")
    judged = [{key: row.pop(key) for key in ("verdict", "taught_by", "hi_limit")} for row in seen]
    assert seen == ordered(health, "bucket")
    assert ordered(shown(session, "quarantine"), "cell_key") == ordered(quarantine, "cell_key")
    found = ordered(shown(session, "fleet"))
    assert [{key: row[key] for key in fleet[0]} for row in found] == ordered(fleet)
    of_channel = {(row["monitor"], row["asset"], row["channel"]): row for row in found}
    for row, said in zip(seen, judged, strict=True):
        channel_row = of_channel[row["monitor"], row["asset"], row["channel"]]
        assert said == {key: channel_row[key] for key in said}


def test_the_limit_is_the_largest_of_three(session: DuckSession) -> None:
    """More than calibration ever showed, and more than the target; only a ready channel has one."""
    plant = Plant()
    monitor = plant.monitor()
    expected = {}
    for verdict in ("ready", "too_fine"):
        for floor in (0.0, 0.01, 0.02, 0.025, 0.2):
            for floor_max in (0.0, 0.03, 0.05, 0.06, 0.5):
                name = f"{verdict} {floor} {floor_max}"
                learnt = plant.support(verdict, floor=floor, floor_max=floor_max)
                plant.version(plant.channel(monitor, name, ""), learnt)
                expected[name] = max(2 * floor, floor_max, 0.05) if verdict == "ready" else None
    plant.write(emptied(session, TABLES), TABLES)
    assert {row["asset"]: row["hi_limit"] for row in shown(session, "fleet")} == expected


def fleet_row(session: DuckSession, *columns: str) -> list[Any]:
    """Some columns of the only channel."""
    (row,) = shown(session, "fleet")
    return [row[column] for column in columns]


def test_contexts_that_differ_are_told_until_a_run_begins_as_early(session: DuckSession) -> None:
    """A later run speaks for an earlier one only if it began to read no later, and read something."""
    told = ("differing_contexts", "repair_from_tick")
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.run(version, [{}] * 8)
    plant.run(version, [{}] * 4, from_bucket=4, read_from=40, context_rows=2)
    plant.run(version, [{}] * 3, from_bucket=6, read_from=60)
    plant.write(emptied(session, TABLES), TABLES)
    assert fleet_row(session, *told) == [1, 40]
    plant.run(version, [{}] * 3, from_bucket=6, read_from=61, context_rows=0)
    plant.run(version, [], from_bucket=9, read_from=10, context_rows=0, read_to=None)
    plant.write(session, TABLES)
    assert fleet_row(session, *told) == [2, 40]
    plant.run(version, [{}] * 4, from_bucket=5, read_from=50)
    plant.write(session, TABLES)
    assert fleet_row(session, *told) == [1, 40]
    plant.run(version, [{}] * 5, from_bucket=4, read_from=40)
    plant.write(session, TABLES)
    assert fleet_row(session, *told) == [0, None]


def test_the_newest_count_of_calibration_and_the_furthest_look_are_shown(session: DuckSession) -> None:
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.run(version, [{}] * 3, calibration_readings=1000, read_to=70)
    plant.run(version, [{}] * 3, calibration_readings=1012, read_to=90)
    plant.run(version, [{}], from_bucket=2, read_to=None)
    plant.write(emptied(session, TABLES), TABLES)
    assert fleet_row(session, "calibration_readings_now", "data_tick") == [1012, 90]
    assert fleet_row(session, "data_time") == [dt.datetime(1970, 1, 1, 0, 0, 0, 90)]


def test_sqlite_shows_the_same(session: DuckSession) -> None:
    """The views are for every engine; here is another one, with the same rows."""
    plant = Plant()
    for name, kind in (("default", "timestamp"), ("counting", "counter")):
        monitor = plant.monitor(name, kind)
        for channel in NAMES:
            version = plant.version(plant.channel(monitor, "R1", channel), plant.support(), start=STEP)
            for number, (begin, is_finished) in enumerate(((0, 1), (3, 0), (4, 1), (2, 1), (5, 1))):
                cells = [{1: 1, number: bucket} for bucket in range(1, 7)]
                found = {"context_rows": number, "calibration_readings": 900 + number}
                plant.run(version, cells, begin, is_finished == 1, **found)
    plant.write(emptied(session, TABLES), TABLES)
    with contextlib.closing(sqlite3.connect(":memory:")) as lite:
        lite.executescript(rendered(engine_named("sqlite"), StateTables()))
        for table in ALL[1:]:
            rows = session.connection.execute(f"SELECT * FROM {ODD(table)}").fetchall()
            for row in rows:
                marks = ", ".join("?" * len(row))
                lite.execute(f"INSERT INTO {called(table)} VALUES ({marks})", row)
        for view in ("health", "quarantine", "fleet"):
            expected = shown(session, view)
            columns = [one for one in expected[0] if not one.endswith(("_time", "_at"))]
            found_rows = lite.execute(f"SELECT {', '.join(columns)} FROM {called(view)}").fetchall()
            wanted = [tuple(row[column] for column in columns) for row in expected]
            assert sorted(found_rows, key=repr) == sorted(wanted, key=repr)


def test_a_look_at_one_machine_reads_only_its_stored_rows(session: DuckSession) -> None:
    """The names become a filter of the stored rows; DuckDB says how many rows come out of the scan."""
    plant = Plant()
    monitor, support = plant.monitor(), plant.support()
    plant.version(plant.channel(monitor, "R0", "j1"), support)
    version = plant.version(plant.channel(monitor, "R1", "j1"), support, window=1, stride=1)
    plant.run(version, [{}])
    plant.write(emptied(session, TABLES), TABLES)
    session.connection.execute(
        f"INSERT INTO {ODD('bucket')} SELECT 100 + n // 4096, 0, 1, 0, 0, 0, 1, 0, 0, 0, NULL, NULL "
        "FROM range(200000) AS others(n)"
    )
    said = session.connection.execute(
        f"EXPLAIN (ANALYZE, FORMAT JSON) SELECT hi FROM {ODD('health')} WHERE asset = 'R1'"
    ).fetchall()[0][1]
    assert 0 < sum(scanned(json.loads(said)["operator"], "Odd_state_bucket")) < 100_000


def scanned(operators: list[dict[str, Any]], table: str) -> Iterator[int]:
    """The rows that come out of each scan of a table."""
    for operator in operators:
        if operator["extra_info"].get("Table", "").endswith(table):
            yield operator["intermediate_rows"]
        yield from scanned(operator.get("children", []), table)
