"""What calibration froze is kept twice: the same sums on every engine and by Python; damage is found."""

import time
from collections.abc import Sequence
from typing import Any

import duckdb
import pyarrow as pa
import pytest

import engines
import gam_db
import scripts
from gam_db.composing import template
from gam_db.errors import StateError
from gam_db.stored.checking import proving
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning.steps import DAY
from strategies import Row
from test_falsified import put_back, stored

PRIME = 2**31 - 1

#: The integers of a version and of its bounds, in the order in which they are summed.
FIGURES = (
    *("channel_id", "support_id", "parent_id", "version_no", "m", "tau", "bins", "window_length"),
    *("stride", "max_gap", "score_from", "calibration_end", "first_scored", "run_up_from"),
    *("calibration_readings", "calibration_samples", "created"),
    *("calibration_vectors", "cells", "seen_once", "blocks", "finest_bins", "vectors_needed"),
    *("still_after", "least_vectors", "is_robust", "dropped_below", "dropped_above"),
)


def rest(number: int) -> int:
    """What SQL leaves of a number: the sign is its own."""
    return abs(number) % PRIME * (1 if number >= 0 else -1)


def mixed(number: int, count: int) -> int:
    return rest(rest(rest(number) * 31 + count + 1) ** 2)


def sums(version: dict[str, Any], tables: dict[str, list[dict[str, Any]]]) -> dict[str, Any]:
    """The checksum of a version, from the rows of the tables."""
    support, key = version["support_id"], version["version_id"]
    (bounds,) = (row for row in tables["bounds"] if row["support_id"] == support)
    figures = {**bounds, **version}
    return {
        "version_id": key,
        "cells_sum": sum(
            mixed(row["cell_key"], row["visits"])
            for row in tables["support"]
            if row["support_id"] == support
        ),
        "intervals_sum": sum(
            mixed(row["time_from"], rest(row["time_to"]))
            for row in tables["calibration"]
            if row["version_id"] == key
        ),
        "figures_sum": sum(
            mixed(figures[name], place)
            for place, name in enumerate(FIGURES)
            if figures[name] is not None
        ),
        **{name: bounds[name] for name in ("calibrated_lo", "calibrated_hi")},
        **{name: version[name] for name in ("target_floor", "settings_hash", "method_hash")},
    }


def made(engine: str) -> Monitor:
    """Two channels with large times, some of a pool, and one without calibration."""
    session, start = engines.session(engine), -(10**15)
    rows: list[Row] = [
        (asset, "x", start + 10**12 * time, float(time * (3 + number) % 11 - 5))
        for number, asset in enumerate(("a", "b", "c"))
        for time in range(90)
        if asset != "c" or time > 50
    ]
    table = scripts.telemetry(session, rows)
    parameters = gam_db.Parameters(m=4, tau=1, bins=30_000, window=8, stride=4)
    intervals = [
        (start, start + 10**13),
        (start + 2 * 10**13, start + 4 * 10**13),
    ]
    calibration = gam_db.Calibration(intervals=intervals, pool=[["a", "b"]])
    prefix = engines.fresh_name("state")
    monitor = Monitor(session, gam_db.Source(table.name), parameters, calibration, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    return monitor


def test_the_sums_are_those_of_python() -> None:
    check_sums("duckdb")


@pytest.mark.full
def test_the_sums_are_those_of_python_on_every_engine(engine: str) -> None:
    check_sums(engine)


def check_sums(engine: str) -> None:
    monitor = made(engine)
    monitor.calibrate(again=True)
    names = ("version", "bounds", "support", "calibration")
    tables = {name: stored(monitor, name).to_pylist() for name in names}
    assert max(row["cell_key"] for row in tables["support"]) > 2**53
    assert min(row["time_from"] for row in tables["calibration"]) < -PRIME
    expected = [sums(version, tables) for version in tables["version"]]
    kept = stored(monitor, "checksum")
    assert sorted(kept.to_pylist(), key=lambda row: row["version_id"]) == expected


def test_the_file_runs_in_duckdb_as_it_is() -> None:
    """With what it reads under the names that it has for it; its macros are DuckDB's own."""
    monitor = made("duckdb")
    kept = stored(monitor, "checksum")
    with duckdb.connect() as shell:
        for name in ("version", "bounds", "support", "calibration"):
            shell.register("rows", stored(monitor, name))
            shell.execute(f"CREATE TABLE stored_{name} AS SELECT * FROM rows")
        shell.execute("CREATE TABLE wanted AS SELECT version_id FROM stored_version")
        frozen, checksum_rows = (
            (template.sql_folder() / f"stored/calibrating/{name}.sql").read_text(encoding="utf-8")
            for name in ("frozen", "checksum_rows")
        )
        shell.execute(f"CREATE VIEW frozen AS {frozen}")
        shell.execute(checksum_rows)
        found = {row[0]: row for row in shell.fetchall()}
        names = [name for name, *_ in shell.description]
    assert found == {row["version_id"]: tuple(row[name] for name in names) for row in kept.to_pylist()}


def damaged(monitor: Monitor, asset: str) -> pa.Table:
    """Let a visit of a cell of an asset go; return the support as it was."""
    rows = stored(monitor, "support")
    active = {row["asset"]: row["support_id"] for row in versions(monitor)}
    changed = rows.to_pylist()
    cell = next(row for row in changed if row["support_id"] == active[asset])
    cell["visits"] += 1
    put_back(monitor, "support", pa.Table.from_pylist(changed, schema=rows.schema))
    return rows


def versions(monitor: Monitor) -> Sequence[dict[str, Any]]:
    slots = {"monitor_id": monitor.state.monitor(monitor.name)["monitor_id"]}
    rows: list[dict[str, Any]] = monitor.state.fetch("stored/state/active", slots).to_pylist()
    return rows


def test_a_run_refuses_what_is_no_longer_what_calibration_froze() -> None:
    refuse("duckdb")


@pytest.mark.full
def test_a_run_refuses_on_every_engine(engine: str) -> None:
    refuse(engine)


def refuse(engine: str) -> None:
    monitor = made(engine)
    sound = damaged(monitor, "a")
    monitor.score(dry_run=True)  # writes nothing, so it may look
    said = r"in 2 channels \('a x': the cells of its support; 'b x'"
    with pytest.raises(StateError, match=said) as caught:
        monitor.score()
    assert "gam check --state" in caught.value.options
    assert stored(monitor, "bucket").num_rows == 0
    assert stored(monitor, "run").num_rows == 0
    found = monitor.checked_state().differences.to_pylist()
    # Other channels, and a pool's other member, are told apart.
    assert {(row["asset"], row["part"]) for row in found if row["part"] == "frozen"} == {
        ("a", "frozen"),
        ("b", "frozen"),
    }
    put_back(monitor, "support", sound)
    monitor.score()
    assert monitor.checked_state().differences.num_rows == 0


def test_all_active_versions_are_verified_once_a_day(monkeypatch: pytest.MonkeyPatch) -> None:
    monitor = made("duckdb")
    monitor.score()
    assert proofs(monitor) == []  # calibrated within a day
    sound = damaged(monitor, "a")
    monitor.score(asset="c")  # reads nothing of a
    began = time.time_ns() // 1000
    monkeypatch.setattr(proving, "now", lambda: began + 2 * DAY)
    with pytest.raises(StateError, match="changed or damaged"):
        monitor.score(asset="c")
    put_back(monitor, "support", sound)
    for _ in range(2):
        monitor.score(asset="c")
    assert proofs(monitor) == ["checksums"]
    # A check that found something is no reason to be at ease; nor is one that is still to come.
    damaged(monitor, "a")
    monitor.check_state()
    monkeypatch.setattr(proving, "now", lambda: began + DAY)
    with pytest.raises(StateError, match="changed or damaged"):
        monitor.score(asset="c")


def proofs(monitor: Monitor) -> list[str]:
    return [row["extent"] for row in stored(monitor, "proof").to_pylist()]
