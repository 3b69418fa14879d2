"""A dbt package on PostgreSQL runs nobody else's code either: models, views and the tests of its own."""

import datetime as dt
from pathlib import Path

import pytest

import dbt_runs
import gam_db
import postgres_server
import postgres_traps
from gam_db.export import Package, write
from small_plant import readings
from small_postgres import administrator

PARAMETERS = gam_db.Parameters(m=2, bins=4, window=20, stride=5)
START = dt.datetime(2026, 1, 1)
HEALTHY = gam_db.Calibration(intervals=[(START, START + dt.timedelta(minutes=99))])


@pytest.mark.full
def test_no_trap_is_called_by_a_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    warehouse = dbt_runs.InPostgres()
    rows = [
        (asset, channel, START + dt.timedelta(minutes=time), value)
        for asset, channel, time, value in sorted(readings(0, 300), key=lambda row: row[2])
    ]
    log = postgres_server.server().folder / "log"
    read = log.stat().st_size
    with administrator() as connection:
        postgres_traps.set_up(connection, warehouse.schema, postgres_traps.known())
        # dbt's own queries of the catalogue would call these, and then not find its tables.
        for operator in ("~~*", "!~~"):
            connection.execute(f"DROP OPERATOR {warehouse.schema}.{operator} (name, name)")
        monkeypatch.setenv("PGOPTIONS", f"-c search_path={warehouse.schema},public")
        source = gam_db.Source("telemetry", time="ts", time_kind="timestamp")
        write(Package(source, PARAMETERS, HEALTHY, "postgres", lookback="2 min"), tmp_path / "package")
        warehouse.arrive(rows[:800])
        dbt_runs.run(tmp_path / "package", warehouse, "build")
        early = len(warehouse.rows("SELECT 1 FROM gam_health"))
        warehouse.arrive(rows[800:])
        dbt_runs.run(tmp_path / "package", warehouse, "build")
        assert len(warehouse.rows("SELECT 1 FROM gam_health")) > early > 0
        said = log.read_bytes()[read:].decode(errors="replace")
        assert postgres_traps.calls(connection) == 0, postgres_traps.told(said)
