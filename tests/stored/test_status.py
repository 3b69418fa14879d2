"""Status: what is told of every channel, from the state alone."""

import datetime as dt
from collections.abc import Iterator
from typing import Any

import pyarrow as pa
import pytest

from gam_db.cli.page import advice
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConfigurationError, ParameterError, StateError
from gam_db.findings import shortcomings
from gam_db.stored import status as stored_status
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.state import State
from stored_rows import STEP, Plant, emptied

TABLES = StateTables()
DAY = 86_400 * 1_000_000

FULL = {0: 10}
QUIET: dict[int, int] = {}


@pytest.fixture(scope="module")
def session() -> Iterator[DuckSession]:
    """A database with state tables; each test takes out the rows of the one before."""
    with DuckSession() as opened:
        yield opened


def status(session: DuckSession, plant: Plant, monitor: str = "default", **more: Any) -> pa.Table:
    """The status of a plant."""
    plant.write(emptied(session, TABLES), TABLES)
    return stored_status.status(State(session, TABLES), monitor, **more)


def test_the_most_urgent_channel_comes_first_and_says_why(session: DuckSession) -> None:
    plant = Plant()
    monitor = plant.monitor()
    learnt = plant.support()
    good = plant.version(plant.channel(monitor, "R2", "j1"), learnt, start=5 * STEP)
    plant.run(good, [QUIET, QUIET, {0: 1}, QUIET, QUIET])
    worn = plant.version(plant.channel(monitor, "R2", "j2"), learnt)
    plant.run(worn, [QUIET, {0: 1}, {0: 2}, FULL])
    coarse = plant.support("too_fine", 0.5, finest_bins=7)
    plant.run(plant.version(plant.channel(monitor, "R1", "j1"), coarse), [FULL, FULL])
    short = plant.support("needs_data", 0.5, vectors_needed=300)
    plant.version(plant.channel(monitor, "R1", "j2"), short)
    plant.run(plant.version(plant.channel(monitor, "R1", "j3"), learnt), [FULL])
    still = plant.version(plant.channel(monitor, "R1", "j4"), plant.support("constant", 0.0))
    plant.run(still, [FULL, FULL])
    plant.version(plant.channel(monitor, "R3", "j1"), plant.support("no_data", None))
    rows = status(session, plant).to_pylist()
    told = [(row["asset"], row["channel"], row["status"], row["needs_attention"]) for row in rows]
    assert told == [
        ("R2", "j2", "high", True),
        ("R1", "j1", "setup", True),
        ("R1", "j2", "setup", True),
        ("R1", "j3", "waiting", False),
        ("R2", "j1", "ok", False),
        ("R1", "j4", "not assessed", False),
        ("R3", "j1", "not assessed", False),
    ]
    first = rows[0]
    assert first["remarks"] == ["far above its limit of 0.050, 50 % of the novel vectors out of range"]
    assert (first["hi"], first["novel_in_window"], first["window"]) == (0.6, 12, 20)
    assert (first["novel_window_before"], first["trend"]) == (1, 11 / 20)
    assert (first["floor"], first["hi_limit"], first["verdict"]) == (0.01, 0.05, "ready")
    assert first["course"] == [None, 0.05, 0.15, 0.6]
    assert first["scored"] == 40
    assert first["last_time"] == first["last_data"] == dt.datetime(1970, 1, 1, 0, 0, 39)
    assert rows[4]["last_time"] == dt.datetime(1970, 1, 1, 0, 0, 54)
    assert [row["remarks"] for row in rows[1:]] == [
        ["grid too fine for its calibration; 7 bins would pass"],
        [
            "calibration too short; it needs about 300 more vectors",
            "HI not yet available: 0 of 20 vectors scored",
        ],
        ["HI not yet available: 10 of 20 vectors scored"],
        [],
        ["constant in calibration: not assessable"],
        [],
    ]


def test_a_long_course_keeps_its_peaks(session: DuckSession) -> None:
    """64 stretches at most, the newest bucket the end of the last one, the highest of each."""
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    fine = plant.version(plant.channel(monitor, "a", "fine"), learnt, window=10, stride=10)
    plant.run(fine, [FULL if number == 150 else QUIET for number in range(200)])
    coarse = plant.version(plant.channel(monitor, "b", "coarse"), learnt, window=160, stride=10)
    plant.run(coarse, [FULL if number == 150 else QUIET for number in range(200)])
    rows = {row["channel"]: row for row in status(session, plant).to_pylist()}
    expected = [0.0] * 64
    expected[64 - (200 - 150)] = 1.0
    assert rows["fine"]["course"] == expected
    expected = [0.0] * 64
    for number in range(150, 166):
        expected[63 - (199 - number) // 2] = 10 / 160
    assert rows["coarse"]["course"] == expected


def test_only_the_active_version_counts(session: DuckSession) -> None:
    plant = Plant()
    channel = plant.channel(plant.monitor(), "R1", "j1")
    plant.run(plant.version(channel, plant.support()), [FULL, FULL, FULL])
    plant.run(plant.version(channel, plant.support(floor=0.04), number=2), [QUIET, QUIET])
    (row,) = status(session, plant).to_pylist()
    assert (row["version"], row["status"], row["hi"], row["hi_limit"]) == (2, "ok", 0.0, 0.1)


def test_a_channel_that_lags_behind_is_silent(session: DuckSession) -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    for name, read_to in (("now", 9 * DAY), ("late", 8 * DAY), ("gone", 6 * DAY), ("none", None)):
        version = plant.version(plant.channel(monitor, name, "j1"), learnt)
        plant.run(version, [QUIET, QUIET], read_to=read_to)
    table = status(session, plant)
    assert table["looked_at"].to_pylist()[0] < dt.datetime(1970, 1, 2)
    silent = dict(zip(table["asset"].to_pylist(), table["silent"].to_pylist(), strict=True))
    assert silent == {"now": False, "late": False, "gone": True, "none": True}
    assert not any(row["remarks"] for row in table.to_pylist())
    for park_after, expected in (("5 d", ["none"]), ("2 h", ["late", "gone", "none"]), (False, [])):
        table = stored_status.status(State(session, TABLES), park_after=park_after)
        found = [row["asset"] for row in table.to_pylist() if row["silent"]]
        assert sorted(found) == sorted(expected)
    with pytest.raises(ParameterError, match="park_after is 'soon'"):
        stored_status.status(State(session, TABLES), park_after="soon")


def test_what_lies_outside_the_contract_is_told(session: DuckSession) -> None:
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.run(version, [QUIET] * 4, calibration_readings=1012)
    plant.run(version, [QUIET] * 2, 3, context_rows=7, read_from=3 * DAY + 1)
    (row,) = status(session, plant).to_pylist()
    assert row["remarks"] == []  # they are data problems
    assert (row["differing_contexts"], row["calibration_rows_added"]) == (1, 12)
    assert row["repair_from"] == dt.datetime(1970, 1, 4, 0, 0, 0, 1)


def test_a_counter_stays_a_counter(session: DuckSession) -> None:
    plant = Plant()
    monitor, learnt = plant.monitor("default", "counter"), plant.support()
    version = plant.version(plant.channel(monitor, "R1", "j1"), learnt)
    plant.run(version, [QUIET] * 4)
    newest: dict[str, Any] = {"context_rows": 7, "read_from": 40, "calibration_readings": 995}
    plant.run(version, [QUIET] * 2, 3, read_to=2**61, **newest)
    lagging = plant.version(plant.channel(monitor, "R1", "j2"), learnt)
    plant.run(lagging, [QUIET], read_to=5)
    table = status(session, plant)
    assert table.schema.field("last_time").type == pa.int64()
    rows = {row["channel"]: row for row in table.to_pylist()}
    assert rows["j1"]["last_data"] == 2**61
    (remark,) = rows["j1"]["remarks"]
    assert remark.startswith("calibration data changed: -5 rows since version 1 was made; gam check")
    problems = stored_status.assessed(State(session, TABLES)).problems.to_pylist()
    found = [(row["kind"], row["since"]) for row in problems]
    assert found == [("jump", None), ("late", 40)]
    assert problems[1]["count"] == 6
    assert problems[1]["advice"].startswith("Run gam score --from 40 to score them")
    assert not any(row["silent"] for row in rows.values())
    told = stored_status.status(State(session, TABLES), park_after=100).to_pylist()
    assert [row["channel"] for row in told if row["silent"]] == ["j2"]
    problems = stored_status.assessed(State(session, TABLES), park_after=100).problems.to_pylist()
    assert f"{2**61 - 5:,} steps behind" in problems[-1]["sentence"]


def test_times_have_a_zone_where_the_source_has_one(session: DuckSession) -> None:
    plant = Plant()
    monitor = plant.monitor("default", "timestamp with time zone")
    plant.run(plant.version(plant.channel(monitor, "R1", "j1"), plant.support()), [QUIET])
    (row,) = status(session, plant).to_pylist()
    assert row["last_time"] == dt.datetime(1970, 1, 1, 0, 0, 9, tzinfo=dt.UTC)


def test_monitors_are_kept_apart(session: DuckSession) -> None:
    plant = Plant()
    for name, asset in (("default", "R1"), ("it's \\another", "R2")):
        version = plant.version(plant.channel(plant.monitor(name), asset, "j1"), plant.support())
        plant.run(version, [FULL, FULL])
    assert status(session, plant, "it's \\another")["asset"].to_pylist() == ["R2"]
    assert stored_status.status(State(session, TABLES))["asset"].to_pylist() == ["R1"]
    with pytest.raises(ConfigurationError, match=r"no monitor 'defualt' yet in gam_.*mean 'default'"):
        stored_status.status(State(session, TABLES), "defualt")


def test_state_that_is_not_there_is_named(session: DuckSession) -> None:
    emptied(session, TABLES)
    with pytest.raises(ConfigurationError, match="`gam calibrate` makes it"):
        stored_status.status(State(session, TABLES))
    with pytest.raises(StateError, match="no state tables other_"):
        stored_status.status(State(session, StateTables(prefix="other_")))


def test_a_monitor_without_channels_has_none(session: DuckSession) -> None:
    plant = Plant()
    plant.monitor()
    table = status(session, plant)
    assert table.num_rows == 0


def test_an_asset_is_as_urgent_as_its_worst_channel(session: DuckSession) -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    for asset, channel, cells in (
        ("a", "j1", QUIET),
        ("a", "j2", {0: 2}),
        ("b", "j1", FULL),
        ("b", "j2", QUIET),
        ("b", "j3", {0: 3}),
        ("c", "j1", QUIET),
    ):
        version = plant.version(plant.channel(monitor, asset, channel), learnt)
        plant.run(version, [QUIET, cells])
    table = status(session, plant)
    found = stored_status.machines(State(session, TABLES), "default", table).to_pylist()
    names = ("asset", "above", "watched", "first_channel", "strongest_channel", "need_attention")
    assert [tuple(row[name] for name in names) for row in found] == [
        ("b", 2, 3, "j1", "j1", 2),
        ("a", 1, 2, "j2", "j2", 1),
        ("c", 0, 1, None, None, 0),
    ]
    assert [row["strength"] for row in found] == [10.0, 2.0, None]


@pytest.mark.parametrize(
    ("verdict", "finest", "remark"),
    [
        ("too_fine", 5, "grid too fine for its calibration; 5 bins would pass"),
        (
            "too_fine",
            4,
            "too little calibration for a useful grid: calibrate longer, it needs about 70 more vectors",
        ),
        ("needs_data", None, "calibration too short; it needs about 70 more vectors"),
    ],
)
def test_where_only_a_useless_grid_would_pass_the_advice_is_to_calibrate_longer(
    verdict: str, finest: int | None, remark: str
) -> None:
    row = {"verdict": verdict, "calibrated_lo": 0.0, "finest_bins": finest, "vectors_needed": 70}
    assert shortcomings(row, 2) == [remark]
    said = " ".join(advice([row]))
    assert ("bins would do" in said) == remark.startswith("grid")
    assert ("longer healthy part" in said) == (not remark.startswith("grid"))
