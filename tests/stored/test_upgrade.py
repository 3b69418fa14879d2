"""A state of an earlier gam-db goes up, shows what it showed, and is scored on; a newer one is refused.

The states lie in ``tests/states/``; ``tests/states/later/`` holds a migration that no gam-db has: it
adds columns and fills them from the buckets, so that every engine shows that it can.
"""

import dataclasses
import shutil
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
import sqlglot
from sqlglot import exp
from typer.testing import CliRunner

import gam_db
import migration_lint
import states
from gam_db.cli import app
from gam_db.engines import NAMES, engine_named
from gam_db.errors import StateError
from gam_db.stored.schema import migration_files, migrations
from gam_db.stored.schema.migration_files import Migration, files, record
from gam_db.stored.schema.tables import StateTables
from states import Before
from visible import visible

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]

RUNS = "SELECT run_id, version_id, buckets, novel FROM gam_run"
BUCKETS = "SELECT run_id, version_id, novel FROM gam_bucket"

ADDED = """
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS buckets BIGINT;
{update};
COMMENT ON COLUMN stored_run.buckets IS 'Buckets';
"""
UPDATE = """
UPDATE stored_run AS kept SET buckets = COALESCE(kept.buckets, found.buckets)
FROM (
    SELECT run_id, version_id, COUNT(*) AS buckets FROM stored_bucket GROUP BY run_id, version_id
) AS found
WHERE kept.run_id = found.run_id AND kept.version_id = found.version_id
"""


@pytest.fixture
def later(tmp_path: Path) -> tuple[Migration, ...]:
    """The migrations of a gam-db that will be: one more."""
    folder = tmp_path / "migrations"
    folder.mkdir()
    checkout = Path(__file__).parent.parent.parent / "migrations"
    for path in checkout.glob("*.sql"):
        shutil.copy(path, folder)
    (one,) = (states.FOLDER / "later").glob("*.sql")
    shutil.copy(one, folder / f"{len(files()) + 1:04}_run.sql")
    return migration_files.read(folder)


@pytest.fixture(params=states.kept())
def before(
    request: pytest.FixtureRequest, engine: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Before:
    return states.put_back(engine, request.param, tmp_path, monkeypatch)


def assert_filled(state: Before) -> None:
    """Each run has as many buckets, and novel vectors in them, as the buckets say."""
    buckets, novel = Counter[Any](), Counter[Any]()
    for row in visible(state.monitor(), BUCKETS):
        key = row["run_id"], row["version_id"]
        buckets[key] += 1
        novel[key] += row["novel"]
    runs = visible(state.monitor(), RUNS)
    assert len({row["run_id"] for row in runs}) > 2
    for row in runs:
        key = row["run_id"], row["version_id"]
        expected = (buckets[key], novel[key]) if key in buckets else (None, None)
        assert (row["buckets"], row["novel"]) == expected
    assert any(row["buckets"] for row in runs)


def test_a_state_goes_up_and_is_scored_on(
    before: Before, later: tuple[Migration, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    mine = before.monitor()
    assert before.health
    assert before.seen() == before.health
    monkeypatch.setattr(migrations, "files", lambda: later)
    with pytest.raises(StateError, match=r"older gam-db: \d+ migrations are pending; run `gam migrate`"):
        mine.score()
    assert len(mine.migrate()) == len(later) - before.migrations
    assert mine.migrate() == []
    assert before.seen() == before.health
    assert_filled(before)
    if before.session.transactions:  # no row is hidden, so no run hides any
        found = visible(mine, "SELECT run_id, hides FROM gam_run")
        assert {row["hides"] for row in found} == {0}
    before.score_on()


def test_filling_may_be_cut_short_anywhere(
    before: Before, later: tuple[Migration, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(migrations, "files", lambda: later[:-1])
    before.monitor().migrate()
    session = type(before.session)
    execute, runs = session.execute, len(visible(before.monitor(), "SELECT run_id FROM gam_run"))
    monkeypatch.setattr(migrations, "files", lambda: later)
    for after in range(20):
        left = after

        def cut(self: Any, statement: exp.Expr) -> None:
            nonlocal left
            if left == 0:
                raise KeyboardInterrupt
            left -= 1
            execute(self, statement)

        with monkeypatch.context() as patched:
            patched.setattr(session, "execute", cut)
            try:
                before.monitor().migrate()
                break
            except KeyboardInterrupt:
                pass
        assert len(visible(before.monitor(), "SELECT run_id FROM gam_run")) == runs
        assert before.seen() == before.health
    assert after >= 3, "each statement was cut off once"
    before.monitor().migrate()
    assert_filled(before)


@pytest.mark.parametrize("name", NAMES)
def test_every_engine_has_a_form_of_filling(name: str, later: tuple[Migration, ...]) -> None:
    """One step, that reads the buckets and writes the runs; its grammar knows it."""
    engine = engine_named(name)
    texts = [engine.text(one) for one in later[-1].statements(engine, StateTables(schema=None))]
    first = ("UPDATE", "MERGE INTO", "INSERT OVERWRITE", "EXCHANGE TABLES")
    steps = [text for text in texts if text.startswith(first)]
    assert len(steps) == 1
    parsed = sqlglot.parse_one(steps[0], dialect=engine.dialect)
    assert {"gam_run"} <= {table.name for table in parsed.find_all(exp.Table)} or "gam_run" in steps[0]
    assert any("gam_bucket" in text for text in texts)
    assert not [text for text in texts if "stored_run" in text]


@pytest.mark.parametrize(
    "update",
    [
        UPDATE.replace("stored_run", "stored_version"),
        UPDATE.replace("COALESCE(kept.buckets, found.buckets)", "found.buckets"),
        UPDATE.replace("SET buckets", "SET rows_read"),
        UPDATE.replace(" AND kept.version_id = found.version_id", ""),
        UPDATE.replace("GROUP BY run_id, version_id", ""),
        UPDATE.partition("WHERE")[0],
        f"{UPDATE};{UPDATE}",
        "UPDATE stored_run AS kept SET buckets = 1",
    ],
)
def test_other_forms_of_filling_are_refused(tmp_path: Path, update: str) -> None:
    made = ["0001_run.sql", "0002_run.sql"]
    checkout = Path(__file__).parent.parent.parent / "migrations"
    shutil.copy(checkout / "0011_run.sql", tmp_path / made[0])
    (tmp_path / made[1]).write_text(ADDED.format(update=UPDATE))
    migration_lint.check(tmp_path)
    (tmp_path / made[1]).write_text(ADDED.format(update=update))
    said = "fills columns in a form that not every engine has"
    with pytest.raises(migration_lint.MigrationError, match=said):
        migration_lint.check(tmp_path)


#: Every command that reads or writes a state.
COMMANDS: list[Sequence[str]] = [
    ["migrate"],
    ["calibrate", states.SOURCE, "--calibration-fraction", "0.5"],
    ["score"],
    ["score", "--copy", "copy.duckdb"],
    ["status"],
    ["check", "--state"],
    ["prune", "--keep", "10"],
    ["compact"],
    ["drop", "--yes"],
]


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_a_newer_state_is_refused_by_every_command(
    command: Sequence[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    newest = states.put_back("duckdb", max(states.kept()), tmp_path, monkeypatch)
    session = newest.session
    newest.monitor().migrate()
    one = dataclasses.replace(files()[-1], number=len(files()) + 1)
    session.execute(record([one], StateTables(), 1))
    there = visible(newest.monitor(), "SELECT * FROM gam_migration ORDER BY number")
    session.close()
    told = CliRunner().invoke(app, [*command, "--database", "plant.duckdb"])
    assert told.exit_code == 1, told.output
    said = " ".join(told.stderr.split())
    assert "were last migrated by gam-db" in said
    assert f"which knows {len(files())}. Install that version or a newer one." in said
    with gam_db.connect("plant.duckdb") as again:
        monitor = states.monitor(again, states.PARAMETERS)
        assert visible(monitor, "SELECT * FROM gam_migration ORDER BY number") == there
    assert sorted(path.name for path in tmp_path.iterdir()) == ["plant.duckdb"]
