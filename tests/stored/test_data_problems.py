"""Data problems: each kind is listed apart from machines that need attention, on every engine alike."""

from typing import Any

import pytest

import engines
import gam_db
import scripts
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.state import State
from gam_db.stored.status import Standing, assessed
from stored_rows import Plant
from strategies import Row

DAY = 86_400 * 1_000_000
NOW = 10 * DAY
HALF = 9 * DAY + DAY // 2
QUIET: dict[int, int] = {}


def stored(plant: Plant, engine: str = "duckdb") -> State:
    """The state tables with the rows of a plant."""
    session = DuckSession() if engine == "duckdb" else engines.session(engine)
    state = State(session, StateTables(prefix=engines.fresh_name("state")))
    migrations.migrate(session, state.tables)
    for name, rows in plant.tables.items():
        state.append_rows(name, rows)
    return state


def listed(standing: Standing) -> list[tuple[Any, ...]]:
    """Kind, asset, count, total, since and until of each problem, times in days."""
    problems = standing.problems
    since, until = (
        [None if one is None else one / DAY for one in problems[name].cast("int64").to_pylist()]
        for name in ("since", "until")
    )
    names = [problems[name].to_pylist() for name in ("kind", "asset", "count", "total")]
    return list(zip(*names, since, until, strict=True))


def test_each_kind_is_listed_by_hand(engine: str) -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    flat = plant.support("constant", 0.0)

    def version(asset: str, support: int = learnt) -> Any:
        return plant.version(plant.channel(monitor, asset, "x"), support)

    plant.run(version("good"), [QUIET] * 4, read_to=HALF)
    plant.run(version("gone"), [QUIET] * 4, read_to=6 * DAY)
    plant.run(version("never"), [], read_to=None)
    plant.run(version("future"), [QUIET] * 4, read_to=400 * DAY)
    back = version("back")  # it read a row of the future once, which is gone
    plant.run(back, [QUIET] * 4, read_to=400 * DAY)
    plant.run(back, [QUIET] * 2, 2, read_to=HALF)
    for asset, rows in (("late", 4), ("lost", 0)):
        made = version(asset)
        plant.run(made, [QUIET] * 4, read_to=8 * DAY)
        plant.run(made, [QUIET] * 2, 2, context_rows=rows, read_from=7 * DAY, read_to=HALF)
    mended = version("mended")  # scored again from before
    plant.run(mended, [QUIET] * 4, read_to=8 * DAY)
    plant.run(mended, [QUIET] * 2, 2, context_rows=4, read_from=7 * DAY, read_to=HALF)
    plant.run(mended, [QUIET] * 4, read_from=6 * DAY, read_to=HALF)
    for asset, readings in (("more", 1012), ("fewer", 990)):
        plant.run(version(asset), [QUIET] * 4, calibration_readings=readings, read_to=HALF)
    plant.run(version("moves", flat), [{0: 4}, {0: 10}, {0: 3}], read_to=HALF)
    plant.run(version("moved", flat), [{0: 10}, QUIET, QUIET], read_to=HALF)
    version("empty", plant.support("no_data", None))
    plant.add(
        "unplaced",
        monitor_id=monitor,
        started=5,
        nameless=1,
        undated=1,
        strangers=40,
        stranger_channels=2,
    )
    standing = assessed(stored(plant, engine), now=NOW)
    assert listed(standing) == [
        ("lost", "lost", 1, None, 7.0, 9.5),
        ("late", "late", 3, None, 7.0, 9.5),
        ("calibration", "more", 12, None, None, None),
        ("constant", "moves", 13, None, None, 29e6 / DAY),
        ("no_data", "empty", None, None, None, None),
        ("silent", "gone", None, None, 6.0, 10.0),
        ("silent", "never", None, None, None, 10.0),
    ]
    channels = {row["asset"]: row for row in standing.channels.to_pylist()}
    assert sorted(name for name, row in channels.items() if row["watched"]) == [
        *("back", "fewer", "future", "good", "late", "lost", "mended", "more")
    ]
    assert standing.watched == 8
    assert sorted(name for name, row in channels.items() if row["silent"]) == ["gone", "never"]
    said = standing.problems["sentence"].to_pylist()
    assert said[1] == (
        "late: late x: at least 3 rows arrived later than lookback, after 1970-01-08 00:00 UTC, so "
        "the scores lack them"
    )
    assert said[5] == "silent: gone x: no row since 1970-01-07 00:00 UTC, 4 d behind the newest data"
    advice = standing.problems["advice"].to_pylist()
    assert advice[1].startswith("Run gam score --from 1970-01-08T00:00:00 to score them")
    told = " ".join(" ".join(row["remarks"]) for row in channels.values())
    assert not any(word in told for word in ("silent", "later than lookback", "has moved since"))


@pytest.mark.parametrize(
    ("reads", "now", "park_after", "expected", "watched"),
    [
        ([9, 9, 9, 9], 10, None, [], 4),
        (
            [9, 9, 5, 5],
            10,
            None,
            [("silent", "2", None, None, 5, 9), ("silent", "3", None, None, 5, 9)],
            2,
        ),
        ([9, 5, 5, 5], 10, None, [("outage", None, 3, 4, 9, None)], 1),
        ([9, None, None, None], 10, None, [("outage", None, 3, 4, 9, None)], 1),
        ([None, None], 10, None, [("outage", None, 2, 2, None, None)], 0),
        # Nothing comes any more: all of them, and the one that ended before besides.
        (
            [5, 5, 5, 3],
            7,
            None,
            [("outage", None, 4, 4, 5, None), ("silent", "3", None, None, 3, 5)],
            0,
        ),
        ([5, 5, 5, 3], 7, "3 d", [], 4),
        ([5, None], 700, False, [], 1),
        # One clock that stands ahead is not the newest data of the fleet.
        ([9, 9, 9, 36500], 10, None, [], 4),
        ([9, 36500], 11, None, [("silent", "0", None, None, 9, 11)], 1),
    ],
)
def test_more_than_half_that_are_silent_are_an_outage(
    reads: list[int | None], now: int, park_after: Any, expected: list[Any], watched: int
) -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    for number, day in enumerate(reads):
        version = plant.version(plant.channel(monitor, str(number), "x"), learnt)
        plant.run(version, [QUIET] * 4, read_to=None if day is None else day * DAY)
    standing = assessed(stored(plant), park_after=park_after, now=now * DAY)
    assert (listed(standing), standing.watched) == (expected, watched)


@pytest.mark.parametrize(
    ("verdict", "scored", "watched", "kinds"),
    [
        (None, False, 0, ["unwatched"]),
        ("ready", False, 0, ["unwatched"]),
        ("ready", True, 1, []),
        ("too_fine", True, 0, ["unwatched"]),
        ("constant", True, 0, ["unwatched"]),
        ("no_data", False, 0, ["unwatched", "no_data"]),
    ],
)
def test_a_monitor_of_which_nothing_is_watched_says_so(
    verdict: str | None, scored: bool, watched: int, kinds: list[str]
) -> None:
    plant = Plant()
    monitor = plant.monitor(time_kind="counter")
    if verdict is not None:
        learnt = plant.support(verdict, None if verdict == "no_data" else 0.01)
        version = plant.version(plant.channel(monitor, "a", "x"), learnt)
        if scored:
            plant.run(version, [QUIET] * 4)
    standing = assessed(stored(plant), now=NOW)
    assert (standing.watched, standing.problems["kind"].to_pylist()) == (watched, kinds)


def test_channels_without_calibration_are_listed_as_long_as_runs_meet_them() -> None:
    plant = Plant()
    monitor = plant.monitor()
    version = plant.version(plant.channel(monitor, "a", "x"), plant.support())
    counts = {"nameless": 0, "undated": 0, "strangers": 7, "stranger_channels": 1}
    plant.run(version, [QUIET] * 4, read_to=HALF, started=3)
    plant.add("unplaced", monitor_id=monitor, started=3, **counts)
    new = {"kind": "unknown", "asset": "a", "channel": "new", "readings": 7, "latest": HALF}
    plant.add("left_out", monitor_id=monitor, started=3, **new)
    met = assessed(stored(plant), now=NOW).problems.to_pylist()
    named = [(row["kind"], row["asset"], row["channel"], row["count"]) for row in met]
    assert named == [("unknown", "a", "new", 7)]
    plant.add("unplaced", monitor_id=monitor, started=4, **dict.fromkeys(counts, 0))
    assert assessed(stored(plant), now=NOW).problems.num_rows == 0


def test_rows_that_are_ahead_are_listed_and_local_times_named() -> None:
    """Of three channels two are two hours ahead of the run."""
    plant, started = Plant(), NOW - 60_000_000
    monitor = plant.monitor()
    for asset in "abc":
        version = plant.version(plant.channel(monitor, asset, "x"), plant.support())
        plant.run(version, [QUIET] * 4, read_to=NOW)
    counts = {"nameless": 0, "undated": 0, "strangers": 0, "stranger_channels": 0}
    plant.add("unplaced", monitor_id=monitor, started=started, **counts)
    for asset in "ab":
        row = {"asset": asset, "channel": "x", "readings": 24, "latest": started + 7_200_000_000}
        plant.add("left_out", monitor_id=monitor, started=started, kind="ahead", **row)
    found = assessed(stored(plant), now=NOW).problems.to_pylist()
    assert [(row["kind"], row["asset"], row["count"]) for row in found] == [
        ("local_times", None, None),
        ("ahead", "a", 24),
        ("ahead", "b", 24),
    ]
    assert found[0]["sentence"] == "local times: most channels are 2 h ahead of now"
    assert "--source-time-zone" in found[0]["advice"]


PARAMETERS = gam_db.Parameters(m=2, tau=5, bins=4, window=40, stride=10)
CALIBRATION = gam_db.Calibration(intervals=[(0, 999)])


def cycle(asset: str, times: range, value: float | None = None, moves: bool = True) -> list[Row]:
    """Readings of an asset: a cycle of four, or a value."""
    return [(asset, "x", time, float(time // 2 % 4) if moves else value) for time in times]


def test_a_fleet_in_which_each_of_it_happens(engine: str) -> None:
    """Steps of two; at 1,600 a backlog comes, rows go, a channel is renamed, and one begins to move."""
    session = engines.session(engine)
    before, after = range(0, 1600, 2), range(1600, 2400, 2)
    rows = [row for asset in ("calm", "late", "lost", "renamed") for row in cycle(asset, before)]
    rows += cycle("flat", before, 7.0, moves=False) + cycle("gone", range(0, 1200, 2))
    rows += cycle("empty", range(0, 1000, 2), moves=False) + cycle("empty", range(1000, 1600, 2))
    prefix = engines.fresh_name("problems")

    def monitor(telemetry: list[Row]) -> Monitor:
        source = gam_db.Source(scripts.telemetry(session, telemetry).name)
        asked = (session, source, PARAMETERS, CALIBRATION)
        return Monitor(*asked, lookback=0, park_after=700, prefix=prefix)

    first = monitor(rows)
    first.migrate()
    first.calibrate()
    first.score()
    assert [row["kind"] for row in first.data_problems().to_pylist()] == ["no_data"]
    rows = [row for row in rows if row[0] != "lost" or row[2] < 1400 or row[2] % 4 == 0]
    rows += cycle("late", range(1401, 1600, 2))
    rows += [row for asset in ("calm", "late", "lost", "flat", "empty") for row in cycle(asset, after)]
    rows += cycle("new name", after)
    second = monitor(rows)
    report = second.score()
    assert report.unknown_channels == {("new name", "x"): {"readings": 400, "latest": 2398}}
    found = second.data_problems().to_pylist()
    assert [(row["kind"], row["asset"]) for row in found] == [
        ("lost", "lost"),
        ("late", "late"),
        ("unknown", "new name"),
        ("constant", "flat"),
        ("no_data", "empty"),
        ("silent", "gone"),
        ("silent", "renamed"),
    ]
    counts = [row["count"] for row in found]
    assert counts[0] in (2, 3)  # of the five samples before the first new bucket
    assert counts[1:] == [4, 400, 40, None, None, None]
    assert [row["since"] for row in found][-2:] == [1198, 1598]
    rows = [row for row in rows if row[0] not in ("gone", "renamed", "new name")]
    third = monitor(rows + [row for name in ("gone", "renamed") for row in cycle(name, after)])
    third.score(full=True, confirm=True)
    kinds = [row["kind"] for row in third.data_problems().to_pylist()]
    assert kinds == ["constant", "no_data"]


def test_a_counter_that_jumped_is_named(engine: str) -> None:
    """By its newest row alone, which is in no bucket yet; a pause of 900 steps is none."""
    session = engines.session(engine)
    rows = cycle("calm", range(0, 1600, 2)) + cycle("jumped", range(0, 1600, 2))
    rows += [*cycle("calm", range(3400, 3600, 2)), ("jumped", "x", 10**9, 1.0)]
    source, prefix = gam_db.Source(scripts.telemetry(session, rows).name), engines.fresh_name("jump")
    monitor = Monitor(session, source, PARAMETERS, CALIBRATION, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    found = monitor.data_problems().to_pylist()
    assert [(row["kind"], row["asset"], row["until"]) for row in found] == [("jump", "jumped", 10**9)]
    assert 10**9 - 1600 <= found[0]["count"] <= 10**9
