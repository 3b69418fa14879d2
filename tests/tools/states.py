"""States as gam-db left them: ``tests/states/NNNN/``, after the migration of that number.

Run as a program, ``python tests/tools/states.py ENGINE ...`` with the paths of pyproject.toml, it makes
those of this commit. They are kept from then on; a later gam-db must bring them up to date. Each holds
what a monitor of two channels has after a second version was made and the tail pruned: a database file
where that can be copied, else the rows of all tables, and what was seen of it by ``gam_health``.
"""

import gzip
import json
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
from sqlglot import exp

import engines
import frozen
import gam_db
import harness
import scripts
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.schema.migration_files import definitions, files
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables
from strategies import Row
from visible import BUCKETS, NOVEL, visible

FOLDER = Path(__file__).parent.parent / "states"

#: What file of its own an engine has, and the address of one.
FILES = {"duckdb": "{}", "sqlite": "sqlite:///{}"}

SOURCE = "telemetry_of_before"
LOOKBACK = 5
CALIBRATION = gam_db.Calibration(intervals=[(0, 79)])
#: Of the version that was retired, and of the active one.
OLD = gam_db.Parameters(m=2, tau=2, bins=3, window=16, stride=4)
PARAMETERS = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)

#: Rows of a channel when it was calibrated, when the state was kept, and when it was scored on.
FIRST, KEPT, END = 100, 180, 230

HEALTH = """
    SELECT asset, channel, version_no, bucket, last_time, hi, novel_in_window, window_length
    FROM gam_health ORDER BY asset, channel, version_no, bucket
"""

ACTIVE = "WHERE version_id IN (SELECT MAX(version_id) FROM gam_version GROUP BY channel_id) ORDER"

TYPES = {"BIGINT": pa.int64(), "DOUBLE": pa.float64()}


def readings(start: int, end: int) -> list[Row]:
    """Two channels that repeat a pattern, and later on less so. It never changes."""
    return [
        (asset, "x", time, float(time % (5 + number) if time < FIRST or time % 13 else time % 11))
        for number, asset in enumerate("ab")
        for time in range(start, end)
    ]


@dataclass
class Before:
    """A state of a number of migrations, put back.

    Attributes:
        session: on it.
        prefix: of its tables.
        migrations: how many there were.
        health: what was seen of it when it was kept.
    """

    session: Session
    prefix: str
    migrations: int
    health: list[dict[str, Any]]

    def monitor(self) -> Monitor:
        """Return its monitor, as a later gam-db has it."""
        return monitor(self.session, PARAMETERS, self.prefix)

    def seen(self) -> list[dict[str, Any]]:
        """Return what is seen of it now."""
        return visible(self.monitor(), HEALTH)

    def score_on(self) -> None:
        """Score what came later, and compare with the reference: one run over everything."""
        mine = self.monitor()
        kept = {(row["asset"], row["bucket"]) for row in visible(mine, BUCKETS.replace("ORDER", ACTIVE))}
        scripts.arrive(self.session, exp.to_table(SOURCE), readings(KEPT, END))
        mine.score()
        asked = (readings(0, KEPT), readings(0, END), PARAMETERS, CALIBRATION)
        for expected, query in ((frozen.buckets, BUCKETS), (frozen.novel_cells, NOVEL)):
            found = visible(mine, query.replace("ORDER", ACTIVE))
            oldest = min(number for _, number in kept)
            wanted = [row for row in expected(*asked) if row["bucket"] >= oldest]
            assert wanted
            harness.assert_same(wanted, found, query)
        assert mine.check_state().num_rows == 0


def monitor(session: Session, parameters: gam_db.Parameters, prefix: str = "gam_") -> Monitor:
    source = gam_db.Source(SOURCE)
    return Monitor(session, source, parameters, CALIBRATION, lookback=LOOKBACK, prefix=prefix)


def kept() -> list[int]:
    """Return after how many migrations states were kept."""
    return sorted(int(path.name) for path in FOLDER.iterdir() if path.name.isdecimal())


def put_back(engine: str, number: int, folder: Path, patched: pytest.MonkeyPatch) -> Before:
    """Return a state of an engine as it was kept.

    Args:
        engine: of it.
        number: how many migrations there were.
        folder: for a database file.
        patched: lets the migrations of that time be those that are applied.
    """
    place = FOLDER / f"{number:04}"
    told = json.loads(gzip.decompress((place / f"{engine}.json.gz").read_bytes()))
    if engine in FILES:
        path = folder / f"plant.{engine}"
        path.write_bytes(gzip.decompress((place / f"{engine}.gz").read_bytes()))
        return Before(gam_db.connect(FILES[engine].format(path)), "gam_", number, told["health"])
    session, prefix = engines.session(engine), engines.fresh_name("before")
    _source(session, readings(0, KEPT))
    tables = StateTables(prefix=prefix)
    then = files()[:number]
    with patched.context() as at_that_time:
        at_that_time.setattr(migrations, "files", lambda: then)
        migrations.migrate(session, tables)
    for name, rows in told["tables"].items():
        if rows:
            _insert(session, tables, name, rows)
    return Before(session, prefix, number, told["health"])


def _source(session: Session, rows: list[Row]) -> None:
    table = exp.to_table(SOURCE)
    if SOURCE in session.relations():
        session.execute(exp.Drop(tables=[table.copy()], kind="TABLE"))
    with session.lent(harness.arrow(rows)) as lent:
        columns = exp.select("asset", "channel", "time", "value").from_(lent)
        session.execute(session.engine.create_table(table, columns))


def _insert(session: Session, tables: StateTables, name: str, rows: list[dict[str, Any]]) -> None:
    defined = definitions()[name].create.this.expressions
    kinds = {column.name: TYPES.get(column.kind.sql("duckdb"), pa.string()) for column in defined}
    columns = list(rows[0])
    loaded = pa.Table.from_pylist(rows, pa.schema([(column, kinds[column]) for column in columns]))
    with session.lent(loaded) as lent:
        names = [exp.to_identifier(column) for column in columns]
        into = exp.Schema(this=tables.table(name), expressions=names)
        session.execute(exp.Insert(this=into, expression=exp.select(*names).from_(lent)))


def make(engine: str, place: Path) -> None:
    """Make the state of an engine as it is at this commit."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"plant.{engine}"
        session = (
            gam_db.connect(FILES[engine].format(path)) if engine in FILES else engines.session(engine)
        )
        with session:
            _source(session, readings(0, FIRST))
            monitor(session, OLD).migrate()
            monitor(session, OLD).calibrate()
            scripts.arrive(session, exp.to_table(SOURCE), readings(FIRST, 150))
            monitor(session, OLD).score()
            mine = monitor(session, PARAMETERS)
            mine.calibrate()
            mine.score()
            scripts.arrive(session, exp.to_table(SOURCE), readings(150, KEPT))
            mine.score()
            assert mine.prune(keep=60).num_rows
            told: dict[str, Any] = {"health": visible(mine, HEALTH), "tables": {}}
            versions = visible(mine, "SELECT DISTINCT version_id FROM gam_visible_bucket")
            assert len(versions) == 4, "two of each channel"
            if engine not in FILES:
                for name in TABLES:
                    rows = session.fetch(exp.select("*").from_(mine.state.tables.table(name)))
                    told["tables"][name] = rows.to_pylist() if name != "migration" else []
            for name in (*VIEWS[::-1], *TABLES) if engine not in FILES else ():
                kind = "VIEW" if name in VIEWS else "TABLE"
                session.execute(exp.Drop(tables=[mine.state.tables.table(name)], kind=kind))
        place.mkdir(exist_ok=True)
        _write(place / f"{engine}.json.gz", json.dumps(told, indent=0).encode())
        if engine in FILES:
            _write(place / f"{engine}.gz", path.read_bytes())


def _write(path: Path, content: bytes) -> None:
    path.write_bytes(gzip.compress(content, mtime=0))


if __name__ == "__main__":
    for name in sys.argv[1:]:
        make(name, FOLDER / f"{len(files()):04}")
