"""The simulated fleet: the same whenever and however it is made, and as its specification describes."""

from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pytest
from numpy.typing import NDArray
from pyarrow import parquet
from typer.testing import CliRunner

from gam_db.cli import app
from gam_db.lab.simulate.fleet import FIRST_TIME, READINGS, Fleet, Joint
from gam_db.lab.simulate.roles import FAULTS, GROWTHS, role_of
from gam_db.lab.simulate.wear import grown, shown

SAMPLES = 20_000
FLEET = Fleet(seed=3, samples=SAMPLES)


@pytest.fixture(scope="module")
def joints() -> list[Joint]:
    return [joint for robot in range(1, 25) for joint in FLEET.robot(robot)]


def invoked(*words: str) -> Any:
    return CliRunner().invoke(app, ["simulate", *words])


def values(joint: Joint) -> NDArray[np.float64]:
    """Readings in order of time, NaN where missing."""
    ordered = joint.readings.sort_by("time")["value"]
    return np.asarray(ordered.fill_null(np.nan).to_numpy())


def values_of(readings: pa.Table) -> NDArray[np.float64]:
    """Readings in the order of arrival, 0 where missing."""
    return np.asarray(np.nan_to_num(readings["value"].fill_null(0).to_numpy()))


def with_event(joints: list[Joint], *events: str) -> list[Joint]:
    return [joint for joint in joints if joint.truth["event"] in events]


def test_a_robot_alone_equals_the_robot_in_the_fleet(joints: list[Joint], tmp_path: Path) -> None:
    alone, whole = tmp_path / "alone.parquet", tmp_path / "whole.parquet"
    common = ("--samples", str(SAMPLES), "--seed", "3")
    assert invoked("fleet", "--out", str(whole), "--robots", "7", *common).exit_code == 0
    assert invoked("fleet", "--out", str(alone), "--only", "7,2", *common).exit_code == 0
    rows = parquet.read_table(whole)
    kept = np.isin(rows["asset"].to_numpy(), ["robot_02", "robot_07"])
    table = parquet.read_table(alone)
    same = rows.filter(pa.array(kept))
    assert table.drop_columns("value").equals(same.drop_columns("value"))
    assert table["value"].is_valid().equals(same["value"].is_valid())
    readings, expected = (one["value"].fill_null(0).to_numpy() for one in (table, same))
    assert np.array_equal(readings, expected, equal_nan=True)
    truth = parquet.read_table(tmp_path / "whole.truth.parquet").to_pylist()
    assert [row["channel"] for row in truth] == [f"joint_{n}" for _ in range(7) for n in range(1, 7)]
    one_by_one = [joint.truth["event"] for joint in joints[: 7 * 6]]
    assert [row["event"] for row in truth] == one_by_one


def test_a_seed_means_one_fleet() -> None:
    def first(fleet: Fleet) -> NDArray[np.float64]:
        return values(next(iter(fleet.robot(1))))

    assert np.array_equal(first(Fleet(3, 2000)), first(Fleet(3, 2000)), equal_nan=True)
    assert not np.array_equal(first(Fleet(3, 2000)), first(Fleet(4, 2000)), equal_nan=True)


@pytest.mark.parametrize("seed", range(5))
def test_roles_of_two_dozen_robots(seed: int) -> None:
    roles = [role_of(seed, robot) for robot in range(1, 25)]
    kinds = [role.kind for role in roles]
    assert kinds[21:] == ["reprogrammed", "rezeroed", "payload"]
    assert (kinds.count("failed"), kinds.count("healthy")) == (5, 16)
    assert "failed" in kinds[:4]
    failed = [role for role in roles if role.kind == "failed"]
    assert {role.fault for role in failed} == set(FAULTS)
    assert {role.growth for role in failed} == set(GROWTHS)
    programs = [role.program for role in roles]
    assert sorted(programs.count(program) for program in set(programs)) == [1] * 20 + [4]
    assert sum(role.silent is not None for role in roles) == 1
    assert sum(role.constant is not None for role in roles) == 1


def test_joints_stay_at_a_few_levels_and_jump_between_them(joints: list[Joint]) -> None:
    for joint in joints[:12]:
        if joint.truth["event"] == "constant":
            continue
        series = values(joint)
        series = series[~np.isnan(series)]
        steps = np.abs(np.diff(series)) / np.ptp(series)
        assert np.mean(steps < 0.08) > 0.85, "most of the time at a level"
        assert np.mean(steps > 0.08) > 0.01, "jumps"
        histogram, _ = np.histogram(series, 100)
        crowded = np.concatenate([[0], (histogram > len(series) / 400).astype(int), [0]])
        assert 3 <= np.count_nonzero(np.diff(crowded) == 1) <= 10


def test_the_truth_names_every_joint_and_what_happened(joints: list[Joint]) -> None:
    assert len(joints) == 24 * 6
    faulty = with_event(joints, *FAULTS)
    assert len(faulty) == 5
    for joint in faulty:
        truth, times = joint.truth, joint.readings["time"].cast(pa.int64()).to_numpy()
        begin, life = times.min(), truth["failed_at"] - times.min()
        assert truth["failed_at"] >= times.max()
        assert 0.4 <= (truth["onset"] - begin) / life <= 0.7
        assert 0.02 <= truth["amplitude"] <= 0.08
    assert len(with_event(joints, "reprogrammed")) == len(with_event(joints, "payload")) == 6
    assert len(with_event(joints, "rezeroed")) == 1
    (silent,), (constant,) = with_event(joints, "silent"), with_event(joints, "constant")
    last = silent.readings["time"].cast(pa.int64()).to_numpy().max()
    assert last < silent.truth["onset"] < last + 200_000 * SAMPLES / 8
    assert len(np.unique(values(constant)[~np.isnan(values(constant))])) == 1


def test_the_dirt_is_there_and_counted(joints: list[Joint]) -> None:
    for joint in joints:
        rows, truth = joint.readings, joint.truth
        times = rows["time"].cast(pa.int64()).to_numpy()
        assert rows["value"].null_count == truth["null_rows"] > 0
        readings = rows["value"].fill_null(0).to_numpy()
        assert np.isnan(readings).sum() == truth["nan_rows"]
        assert len(times) - len(np.unique(times)) == truth["repeated_rows"]
        assert bool((np.diff(times) < 0).any()) == bool(truth["repeated_rows"] or truth["late_rows"])
    per_robot = [joints[n : n + 6] for n in range(0, len(joints), 6)]
    for robot in per_robot:
        assert sum(joint.truth["repeated_rows"] > 0 for joint in robot) == 1
        assert sum(joint.truth["late_rows"] > 0 for joint in robot) == 1


def test_stops_have_constant_rows_or_none(joints: list[Joint]) -> None:
    for joint in joints[:12]:
        series = values(joint)
        times = np.unique(joint.readings["time"].cast(pa.int64()).to_numpy())
        assert np.diff(times).max() > 20_000_000, "without rows"
        changes = np.flatnonzero(np.diff(series) != 0)
        assert np.diff(changes).max() > 5 * 20, "with constant rows"


@pytest.mark.parametrize("growth", GROWTHS)
def test_wear_grows_from_nothing_to_all(growth: str) -> None:
    age = np.linspace(-1, 1, 2001)
    size = grown(growth, age, np.random.default_rng(1))
    assert not size[age < 0].any()
    assert size[-1] == pytest.approx(1)
    assert ((size >= 0) & (size <= 1)).all()
    assert bool((np.diff(size) < 0).any()) == (growth == "steps"), "only lubrication takes wear back"


def test_faults_show_where_they_should() -> None:
    """Friction shifts whole moves, backlash widens levels, transients touch a few samples of a jump."""
    random = np.random.default_rng(0)
    moves = np.repeat(np.resize(np.arange(8), 400), 10)  # six regular moves, the rare one, the wait
    places = np.array([0, 1, 2, 0, 1, 3, 4, 2])
    full = np.ones(len(moves))
    friction = shown("friction", full, moves, places, random)
    by_move = [np.unique(friction[moves == move]) for move in range(8)]
    assert [len(offsets) for offsets in by_move] == [1] * 8
    assert by_move[7] == 0
    assert {float(np.sign(offsets[0])) for offsets in by_move[:7]} == {-1.0, 1.0}

    backlash = shown("backlash", full, moves, places, random)
    touched = np.unique(places[moves[backlash != 0]])
    assert 1 <= len(touched) <= 2
    assert abs(backlash.mean()) < 0.05 < backlash.std()

    transients = shown("transients", full, moves, places, random)
    assert set(np.flatnonzero(transients) % 10) == {0, 1, 2}
    for added in (friction, backlash, transients):
        assert 0.4 < np.abs(added).max() <= 1


def test_faults_are_small_beside_the_range(joints: list[Joint]) -> None:
    """Whatever the fault, the readings leave the healthy range by less than a tenth of it."""
    for joint in with_event(joints, *FAULTS):
        series = values(joint)
        range_of_joint = np.ptp(series[~np.isnan(series)])
        healthy, end = series[: len(series) // 3], series[-len(series) // 20 :]
        beyond = max(np.nanmax(end) - np.nanmax(healthy), np.nanmin(healthy) - np.nanmin(end))
        assert beyond < 0.1 * range_of_joint


def test_products_are_made_in_shifts_and_named_in_a_column(tmp_path: Path) -> None:
    out = tmp_path / "line.parquet"
    words = ("--only", "1", "--samples", "6000", "--products", "3", "--seed", "5")
    assert invoked("fleet", "--out", str(out), *words).exit_code == 0
    table = parquet.read_table(out)
    assert table.column_names == ["asset", "channel", "time", "value", "product"]
    rows = table.filter(pc.equal(table["channel"], "joint_1"))
    # A thirtieth of 6,000 samples at 5 Hz: a product lasts 40 seconds.
    shift = (rows["time"].cast(pa.int64()).to_numpy() - FIRST_TIME) // 40_000_000
    made = rows["product"].to_numpy()
    assert set(made) == {"product_1", "product_2", "product_3"}
    assert all(len(set(made[shift == number])) == 1 for number in set(shift))
    assert [len(Fleet(3, 6000, products=n)._robot(1)._others) for n in (1, 2, 3)] == [0, 1, 2]


def test_the_first_product_is_the_most_frequent_one() -> None:
    shifts = np.concatenate([Fleet(3, 6000, products=3)._robot(n)._products for n in range(1, 41)])
    shares = np.bincount(shifts) / len(shifts)
    assert shares == pytest.approx([4 / 7, 2 / 7, 1 / 7], abs=0.05)


def test_the_product_is_that_of_each_reading_whatever_the_order_of_arrival() -> None:
    """What one product shows differs from what another does, in the rows that came late, too."""
    for joint in Fleet(3, 6000, products=2).robot(1):
        late = joint.readings
        shift = (late["time"].cast(pa.int64()).to_numpy() - FIRST_TIME) // 40_000_000
        drawn = Fleet(3, 6000, products=2)._robot(1)._products
        assert late["product"].to_pylist() == [f"product_{drawn[number] + 1}" for number in shift]


def test_without_products_nothing_changes() -> None:
    """The first product is the program that a robot repeats without any others."""
    alone = Fleet(3, 6000).joint(1, 1).readings
    among = Fleet(3, 6000, products=3).joint(1, 1).readings
    assert alone.schema == READINGS
    assert Fleet(3, 6000).schema == READINGS
    assert among["time"].equals(alone["time"])
    first = pc.equal(among["product"], "product_1").to_numpy()
    apart = np.abs(values_of(alone) - values_of(among)) > 0.1 * np.ptp(values_of(alone))
    assert apart[first].mean() < 0.2
    assert apart[~first].mean() > 0.5


@pytest.mark.parametrize("fault", FAULTS)
def test_wear_shows_in_every_product(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    robot = next(number for number in range(1, 40) if role_of(3, number).fault == fault)
    joint = role_of(3, robot).joint
    assert joint is not None
    fleet = Fleet(3, 60_000, products=2)
    worn = fleet.joint(robot, joint)
    monkeypatch.setattr("gam_db.lab.simulate.fleet.shown", lambda _, size, *others: np.zeros(len(size)))
    sound = fleet.joint(robot, joint)
    differs = values_of(worn.readings) != values_of(sound.readings)
    made = worn.readings["product"].to_numpy()
    later = worn.readings["time"].cast(pa.int64()).to_numpy() > worn.truth["onset"]
    assert {str(name) for name in made[differs & later]} == {"product_1", "product_2"}


def test_a_fleet_in_a_database(tmp_path: Path) -> None:
    out = tmp_path / "plant.duckdb"
    for _ in range(2):  # the second run replaces the first
        answer = invoked(
            "fleet", "--out", str(out), "--only", "4", "--samples", "2000", "--table", "arm's data"
        )
        assert answer.exit_code == 0, answer.stderr
    with duckdb.connect(str(out)) as connection:
        tables = {name for (name,) in connection.execute("SHOW TABLES").fetchall()}
        rows = connection.table('"arm\'s data"').to_arrow_table()
    assert tables == {"arm's data", "arm's data_truth"}
    expected = pa.concat_tables([joint.readings for joint in Fleet(0, 2000).robot(4)])
    assert rows["time"].to_pylist() == expected["time"].to_pylist()
    assert rows["value"].null_count == expected["value"].null_count


def test_a_view_is_not_replaced(tmp_path: Path) -> None:
    out = tmp_path / "plant.duckdb"
    with duckdb.connect(str(out)) as connection:
        connection.execute("CREATE VIEW telemetry AS SELECT 1 AS one")
    answer = invoked("fleet", "--out", str(out), "--only", "4", "--samples", "2000")
    assert answer.exit_code == 1
    assert "something else than a table is called 'telemetry'" in answer.stderr
    with duckdb.connect(str(out)) as connection:
        assert connection.execute("SHOW TABLES").fetchall() == [("telemetry",)]


def test_the_langevin_system_with_its_truth(tmp_path: Path) -> None:
    out = tmp_path / "system.parquet"
    assert invoked("langevin", "--out", str(out), "--samples", "1000").exit_code == 0
    assert parquet.read_table(out).num_rows == 1000
    (truth,) = parquet.read_table(tmp_path / "system.truth.parquet").to_pylist()
    assert (truth["onset"], truth["failed_at"]) == (400, 999)


def test_what_cannot_be_made_is_refused(tmp_path: Path) -> None:
    refused = {
        "give a name in .parquet": ("fleet", "--out", str(tmp_path / "fleet.csv")),
        "there is no folder": ("fleet", "--out", str(tmp_path / "no" / "fleet.parquet")),
        "numbers of robots": ("fleet", "--out", str(tmp_path / "f.parquet"), "--only", "0"),
        "it takes 1 to 20": ("fleet", "--out", str(tmp_path / "f.parquet"), "--products", "21"),
        "at least 2000": ("fleet", "--out", str(tmp_path / "f.parquet"), "--samples", "10"),
    }
    for words, command in refused.items():
        answer = invoked(*command)
        assert answer.exit_code == 1
        assert words in answer.stderr
    assert not list(tmp_path.iterdir())
