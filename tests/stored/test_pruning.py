"""Pruning: what is old goes, what a restart needs stays, and what is seen of the rest stays as it is."""

from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConfigurationError, EngineError, ParameterError
from gam_db.stored import pruning
from gam_db.stored.planning.steps import DAY
from gam_db.stored.pruning import COUNTED, prune
from gam_db.stored.schema.tables import TABLES as ALL
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.state import State, first_run_at, now
from gam_db.stored.status import status
from state_names import called
from stored_rows import STEP, Plant, Version, emptied

TABLES = StateTables()


@pytest.fixture(scope="module")
def session() -> Iterator[DuckSession]:
    """A database with state tables; each test takes out the rows of the one before."""
    with DuckSession() as opened:
        yield opened


def rows(session: DuckSession, table: str, columns: str = "*") -> list[tuple[Any, ...]]:
    """All rows of a state table or view, in an order."""
    query = f"SELECT {columns} FROM {called(table)} ORDER BY ALL"
    found: list[tuple[Any, ...]] = session.connection.execute(query).fetchall()
    return found


def everything(session: DuckSession) -> dict[str, list[tuple[Any, ...]]]:
    """All that is stored."""
    return {table: rows(session, table) for table in ALL if table != "migration"}


@st.composite
def channels(draw: st.DrawFn, plant: Plant, monitor: int, name: str) -> list[Version]:
    """The versions of one channel, the active one last."""
    channel = plant.channel(monitor, "R1", name)
    versions = []
    for number in range(1, draw(st.integers(1, 3)) + 1):
        stride = draw(st.integers(1, 2))
        version = plant.version(
            channel,
            plant.support(cells=range(3)),
            number,
            window=stride * draw(st.integers(1, 3)),
            stride=stride,
            start=(3 * number + draw(st.integers(0, 5))) * STEP,
        )
        for _ in range(draw(st.integers(0, 4))):
            cells = st.dictionaries(st.integers(0, 3), st.integers(1, 2), max_size=2)
            plant.run(
                version,
                draw(st.lists(cells, max_size=6)),
                draw(st.integers(0, len(version.buckets))),
                committed=draw(st.integers(0, 3)) > 0,
            )
        versions.append(version)
    return versions


Stays = tuple[set[tuple[int, int]], set[tuple[int, int, int]]]


def staying(versions: list[Version], retention: dict[str, Any], most: int) -> Stays:
    """What must stay of the versions of a channel: its buckets, and its novel cells in buckets."""
    buckets, novel = set(), set()
    keep, keep_novel = retention["keep"], retention["keep_novel"]
    newest = max((one.last_time(len(one.buckets) - 1) for one in versions if one.buckets), default=0)
    for version in versions:
        count, length = len(version.buckets), version.window // version.stride
        last = [version.last_time(bucket) for bucket in range(count)]
        late = sum(time >= last[-1] - retention["lookback"] for time in last)
        written = 0
        for bucket in reversed(range(count)):
            needed = version is versions[-1] and bucket >= count - late - length
            if not needed and keep is not None and last[bucket] < newest - keep:
                break
            buckets.add((version.version_id, bucket))
            cells = version.buckets[bucket][2]
            written += len(cells)
            if written <= most if keep_novel is None else last[bucket] >= newest - keep_novel:
                novel |= {(version.version_id, bucket, cell) for cell in cells}
    return buckets, novel


@pytest.mark.thorough
@given(data=st.data())
@settings(max_examples=12)
def test_what_is_young_or_needed_stays_and_nothing_else(
    session: DuckSession, data: st.DataObject
) -> None:
    plant = Plant()
    mine, other = plant.monitor("default", "counter"), plant.monitor("other", "counter")
    drawn = [data.draw(channels(plant, mine, name)) for name in ("j1", "j2")]
    strangers = {version.version_id for version in data.draw(channels(plant, other, "j1"))}
    plant.write(emptied(session, TABLES), TABLES)
    ages = st.none() | st.integers(0, 12).map(lambda age: age * STEP)
    said: dict[str, Any] = {
        "keep": data.draw(ages),
        "keep_novel": data.draw(ages),
        "keep_versions": data.draw(st.none() | st.integers(0, 1)),
        "lookback": data.draw(st.integers(0, 6)) * STEP,
    }
    most = data.draw(st.integers(0, 8))
    kept = None if said["keep_versions"] is None else -1 - said["keep_versions"]
    active = [versions[kept:] for versions in drawn]
    expected = [staying(versions, said, most) for versions in active]

    before, told = everything(session), status(State(session, TABLES)).to_pylist()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pruning, "NOVEL_ROWS", most)
        tried = prune(State(session, TABLES), **said, dry_run=True)
        assert everything(session) == before
        done = prune(State(session, TABLES), **said)
    assert done.equals(tried)

    after = everything(session)
    bucket_rows = [row for row in after["bucket"] if row[0] not in strangers]
    novel_rows = [row for row in after["novel"] if row[0] not in strangers]
    assert [row[:2] for row in bucket_rows] == sorted(set.union(*(one[0] for one in expected)))
    cells = [(row[0], row[1], row[3]) for row in novel_rows]
    assert sorted(cells) == sorted(set.union(*(one[1] for one in expected)))
    for table, columns in {"bucket": 10, "novel": 7}.items():  # a view has the columns that it reads
        assert set(rows(session, f"visible_{table}")) >= {
            row[:columns] for row in after[table] if row[0] not in strangers
        }
    for table, column in {"bucket": 0, "novel": 0, "run": 1}.items():
        left, was = ([row for row in of[table] if row[column] in strangers] for of in (after, before))
        assert left == was
    versions_left = {version.version_id for versions in active for version in versions} | strangers
    assert {row[0] for row in after["version"]} == versions_left
    again = status(State(session, TABLES)).to_pylist()
    for row, was in zip(again, told, strict=True):
        # Where pruning cut the run above the limit, the oldest bucket that is left is the least.
        kept, begun = row.pop("onset"), was.pop("onset")
        assert kept == begun or (
            row["judged_by"] == "indicator" and None not in (kept, begun) and kept > begun
        )
        for changing in ("course", "course_from", "remarks"):
            del row[changing], was[changing]
    assert again == told
    assert [sum(row[f"{one}_after"] for row in done.to_pylist()) for one in COUNTED[:2]] == [
        len(bucket_rows),
        len(novel_rows),
    ]

    for version in (versions[-1] for versions in drawn):
        last = [version.last_time(bucket) for bucket in range(len(version.buckets))]
        begin = sum(time < last[-1] - said["lookback"] for time in last)
        plant.run(version, [{0: 1}, {}, {1: 2}], begin)
    plant.write(session, TABLES)
    seen = {row[:2]: row[-3:] for row in rows(session, "visible_bucket")}
    for versions, (buckets, _) in zip(drawn, expected, strict=True):
        version = versions[-1]
        for bucket, (novel, _, _) in enumerate(version.buckets):
            key = (version.version_id, bucket)
            if key in buckets or bucket >= len(version.buckets) - 3:
                assert seen[key] == (novel, novel // 2, version.in_window(bucket))


def test_a_saturated_channel_is_bounded_where_nothing_is_said(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every vector is novel and in a cell of its own, the worst that a channel can do."""
    monkeypatch.setattr(pruning, "NOVEL_ROWS", 25)
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support(cells=range(7))
    version = plant.version(plant.channel(monitor, "R1", "saturated"), learnt)
    plant.run(version, [{10 * bucket + n: 1 for n in range(10)} for bucket in range(50)])
    healthy = plant.version(plant.channel(monitor, "R1", "healthy"), learnt)
    plant.run(healthy, [{bucket: 1} if bucket % 10 == 0 else {} for bucket in range(50)])
    plant.write(emptied(session, TABLES), TABLES)
    sizes = prune(State(session, TABLES)).to_pylist()
    counts = ("channel", "bucket_rows", "bucket_rows_after", "novel_rows", "novel_rows_after")
    assert [tuple(row[count] for count in counts) for row in sizes] == [
        ("saturated", 50, 50, 500, 20),
        ("healthy", 50, 50, 5, 5),
    ]
    assert [row["support_rows"] for row in sizes] == [7, 7]
    assert {row[1] for row in rows(session, "novel") if row[0] == version.version_id} == {48, 49}


def test_a_version_goes_with_what_only_it_had_learnt(session: DuckSession) -> None:
    plant = Plant()
    monitor, pooled = plant.monitor(), plant.support(cells=[1])
    first, second = plant.channel(monitor, "R1", "j1"), plant.channel(monitor, "R2", "j1")
    old = [plant.support(cells=[2, 3]), pooled, plant.support(cells=[4])]
    for number, learnt in enumerate(old, start=1):
        version = plant.version(first, learnt, number)
        plant.run(version, [{}])
        plant.add("horizon", version_id=version.version_id, first_bucket=0, first_novel=0)
    plant.version(second, pooled)
    for learnt in old:
        plant.add(
            "block",
            support_id=learnt,
            block=0,
            channel_id=first,
            first_time=0,
            last_time=0,
            vectors=1,
            novel=0,
        )
        plant.add("ladder", support_id=learnt, bins=4, floor=0.5)
        plant.add("probe", support_id=learnt, change_no=1, change_name="frozen", vectors=9, novel=3)
    plant.write(emptied(session, TABLES), TABLES)
    prune(State(session, TABLES), keep_versions=0)
    assert [row[0] for row in rows(session, "version", "version_no, channel_id")] == [1, 3]
    assert len(rows(session, "calibration")) == len(rows(session, "run")) + 1 == 2
    assert rows(session, "horizon", "version_id") == [(version.version_id,)]
    for table in ("support", "bounds", "block", "ladder", "probe"):
        assert {row[0] for row in rows(session, table)} == {pooled, old[2]}


def test_records_of_runs_go_unless_they_still_tell_something(session: DuckSession) -> None:
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    first = plant.run(version, [{}] * 6, read_to=3 * STEP)
    plant.run(version, [{}] * 3, from_bucket=3, calibration_readings=999)
    counted = plant.run(version, [{}] * 3, from_bucket=3, calibration_readings=1000)
    plant.run(version, [{}] * 2, from_bucket=4, settled_bucket=3)
    settled = plant.run(version, [{}] * 2, from_bucket=4, settled_bucket=3)
    differing = plant.run(version, [{}] * 2, from_bucket=4, context_rows=9)
    plant.run(version, [{}], from_bucket=5, read_to=900 * STEP)
    furthest = plant.run(version, [{}], from_bucket=5, read_to=900 * STEP)
    for _ in range(20):
        newest = plant.run(version, [{}], from_bucket=5)
    plant.write(emptied(session, TABLES), TABLES)
    prune(State(session, TABLES))
    left = [first, counted, settled, differing, furthest, newest]
    assert [row[0] for row in rows(session, "run", "run_id")] == left
    plant.run(version, [{}] * 4, from_bucket=5, settled_bucket=8)
    plant.write(session, TABLES)
    prune(State(session, TABLES), keep=0, lookback=0)
    assert differing not in [row[0] for row in rows(session, "run", "run_id")]


def test_without_transactions_what_a_run_left_without_end_waits_for_a_day(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It may still be at work, unless a later one of its channel has finished."""
    monkeypatch.setattr(session, "transactions", False)
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.ids = first_run_at(now() - 2 * DAY)
    plant.run(version, [{}] * 3, committed=False)
    plant.ids = first_run_at(now())
    plant.run(version, [{}] * 2, committed=False)
    finished = plant.run(version, [{}] * 3)
    young = plant.run(version, [{}] * 2, from_bucket=3, committed=False)
    other = plant.version(plant.channel(1, "R2", "j1"), plant.support())
    plant.ids = first_run_at(now() - 2 * DAY)
    plant.run(other, [{}] * 3, committed=False)
    plant.write(emptied(session, TABLES), TABLES)
    prune(State(session, TABLES))
    assert {row[2] for row in rows(session, "bucket")} == {finished, young}


def test_what_cannot_be_pruned_is_refused(session: DuckSession) -> None:
    plant = Plant()
    plant.monitor()
    plant.write(emptied(session, TABLES), TABLES)
    for wrong, message in (
        ({"keep": "soon"}, "keep is 'soon'"),
        ({"keep_novel": -1}, "keep_novel is -1"),
        ({"lookback": "x"}, "lookback is 'x'"),
        ({"keep_versions": -1}, "keep_versions is -1"),
    ):
        with pytest.raises(ParameterError, match=message):
            prune(State(session, TABLES), **wrong)
    with pytest.raises(ConfigurationError, match="no monitor 'nobody'"):
        prune(State(session, TABLES), "nobody")
    with session.transaction(), pytest.raises(EngineError, match="transaction open"):
        prune(State(session, TABLES))
