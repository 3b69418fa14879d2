"""Owner, writer and reader: gam migrate --sql --grants gives them what they need, and no more."""

import re
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psycopg
import pytest
from psycopg import sql
from typer.testing import CliRunner

import gam_db
import postgres_server
from gam_db.cli import app
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.tables import TABLES, VIEWS
from small_plant import readings
from small_postgres import administrator, database, source
from state_names import called

pytestmark = pytest.mark.migrates

#: Roles with names that must be quoted.
OWNER, WRITER, READER = "plant owner", 'the "writer"', "Reader"
GRANTS = f"owner={OWNER},writer={WRITER},reader={READER}"
SCHEMA = "plant state"
SETTINGS = (
    *("--m", "2", "--bins", "4", "--window", "10", "--stride", "5", "--calibrate", "0/99"),
    *("--rate", "100 per 1000 judgements", "--least-vectors", "20"),
)

#: What the status takes, and what there is to look at.
STATUS = {"migration", "monitor", "proof", "visible_bucket", "fleet", "machine", "stillness"}
STATUS |= {"version", "bounds", "run", "finished_run", "unplaced", "left_out", "unjudged_program"}
SHOWN = {"health", "quarantine", "unplaced_day", "onset", "growth", "cell", "trend"}
SHOWN |= {"channel", "limit", "alarm", "ladder", "probe", "program", "label", "last_run"}
SHOWN |= {"visible_judgement", "labelled_episode", "alarm_event", "alarm_band", "alarm_cell"}

#: The views that a writer takes, and the tables whose rows stay.
COUNTING = {"finished_run", "visible_bucket", "visible_novel", "fleet"}
COUNTING |= {"visible_judgement", "visible_episode", "stillness"}
COUNTING |= {"visible_program", "unjudged_program", "alarm"}
KEPT = {"migration", "monitor", "channel", "proof", "episode", "label"}

#: What a writer does.
WORK = (
    ("calibrate", "telemetry", *SETTINGS),
    ("score",),
    ("label", "1", "true_fault"),
    ("score", "--full"),
    ("calibrate", "telemetry", *SETTINGS, "--again"),
    ("score", "--everything"),
    ("check", "telemetry", "--state"),
    ("prune", "--keep-versions", "0", "--keep-novel", "10", "--keep", "100"),
)

NAMELESS = "INSERT INTO telemetry SELECT NULL, channel, time + 50, value FROM telemetry WHERE time > 290"

BUCKETS = f'SELECT asset, bucket, novel, samples FROM "{SCHEMA}".gam_health ORDER BY 1, 2'

COLUMNS = "SELECT attname FROM pg_attribute WHERE attrelid = %s::regclass AND attnum > 0"


@pytest.fixture
def plant() -> Iterator[Any]:
    """A database whose doors are closed, with telemetry and three roles who may connect."""
    with database() as name, administrator(name) as connection:
        connection.execute(f"REVOKE ALL ON DATABASE {name} FROM PUBLIC")
        connection.execute("REVOKE ALL ON SCHEMA public FROM PUBLIC")
        source(connection, readings(0, 300))
        roles = [sql.Identifier(role) for role in (OWNER, WRITER, READER)]
        for role in roles:
            connection.execute(sql.SQL("CREATE ROLE {} LOGIN").format(role))
            connection.execute(
                sql.SQL("GRANT CONNECT, TEMPORARY ON DATABASE {} TO {}").format(
                    sql.Identifier(name), role
                )
            )
        connection.execute(sql.SQL("GRANT USAGE ON SCHEMA public TO {}").format(roles[1]))
        connection.execute(sql.SQL("GRANT SELECT ON telemetry TO {}").format(roles[1]))
        yield connection
        for role in roles:
            connection.execute(sql.SQL("DROP OWNED BY {} CASCADE").format(role))
            connection.execute(sql.SQL("DROP ROLE {}").format(role))


def url(plant: Any, role: str) -> str:
    user = role.replace(" ", "%20").replace('"', "%22")
    return postgres_server.server().url_of(plant.info.dbname, user)


def script(grants: str = GRANTS) -> str:
    words = ["migrate", "--sql", "--engine", "postgres", "--schema", SCHEMA, "--grants", grants]
    result = CliRunner().invoke(app, words)
    assert result.exit_code == 0, result.output
    return result.stdout


def administered(plant: Any) -> None:
    """Let an administrator run the script."""
    address = postgres_server.server().url_of(plant.info.dbname)
    command = ["psql", "-X", "-q", "-v", "ON_ERROR_STOP=1", address]
    done = subprocess.run(command, input=script(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def gam(plant: Any, role: str, *words: str) -> tuple[int, str]:
    """Run a command as a role; return its exit code, and what it says."""
    options = ("--database", url(plant, role), "--schema", SCHEMA)
    result = CliRunner().invoke(app, [*words, *options])
    return result.exit_code, " ".join(result.output.split())


def refused(plant: Any, role: str, *words: str) -> bool:
    code, said = gam(plant, role, *words)
    assert (code == 1) is ("PostgreSQL user lacks a privilege" in said or "must be owner" in said), said
    return code == 1


def denied(connection: Any, statement: str) -> bool:
    """Tell whether a statement is refused for want of a privilege; it is undone if not."""
    try:
        with connection.transaction(force_rollback=True):
            connection.execute(statement)
    except psycopg.errors.InsufficientPrivilege:
        return True
    return False


def worked(plant: Any, give: Callable[[str], None] | None = None) -> None:
    """Do all that a writer does; what a refusal names is given, and the same done again."""
    for words in WORK:
        if words == ("score", "--everything"):  # on the way there are readings of nobody
            plant.execute(NAMELESS)
        while (result := gam(plant, WRITER, *words))[0] == 1 and give is not None:
            give(result[1])
        assert result[0] in (0, 2, 4), result[1]


def test_each_does_its_work_and_no_other(plant: Any) -> None:
    administered(plant)
    worked(plant)
    assert plant.execute(f'SELECT differences FROM "{SCHEMA}".gam_state_proof').fetchall()
    owners = "SELECT DISTINCT pg_get_userbyid(relowner) FROM pg_class WHERE relname LIKE 'gam%'"
    assert plant.execute(owners).fetchall() == [(OWNER,)]

    code, said = gam(plant, READER, "status")
    assert code in (0, 2, 4)
    assert "of 4 channels watched" in said
    with gam_db.Monitor(url(plant, READER), gam_db.Source("telemetry"), schema=SCHEMA) as mine:
        assert mine.health().num_rows > 0
    for words in ("score", "calibrate telemetry", "prune", "drop --yes", "migrate --prefix other_"):
        assert refused(plant, READER, *words.split())
    for words in ("drop --yes", "migrate --prefix other_"):
        assert refused(plant, WRITER, *words.split())
    assert not refused(plant, OWNER, "migrate", "--prefix", "other_")


def test_a_writer_runs_a_script_and_a_reader_does_not(plant: Any, tmp_path: Path) -> None:
    """And both see how old the last run is."""
    administered(plant)
    path = tmp_path / "run.sql"
    assert gam(plant, WRITER, *WORK[0])[0] in (0, 2)
    assert gam(plant, WRITER, "compile", "--form", "monitor", "--out", str(path))[0] == 0
    for role, is_refused in ((READER, True), (WRITER, False)):
        words = ["psql", "-X", "-d", url(plant, role), "-f", str(path)]
        done = subprocess.run(words, capture_output=True, text=True)
        assert ("permission denied" in done.stderr) is is_refused, done.stderr
        assert (done.returncode != 0) is is_refused
    with psycopg.connect(url(plant, READER), autocommit=True) as mine:
        ((count,),) = mine.execute(f'SELECT count(*) FROM "{SCHEMA}".gam_last_run').fetchall()
        assert count == 1
    assert plant.execute(BUCKETS).fetchall()


@pytest.mark.parametrize("role", [READER, WRITER])
def test_statements_of_all_kinds(plant: Any, role: str) -> None:
    """What is not granted is refused, table by table and column by column."""
    administered(plant)
    written = {"migration": "applied_at", "monitor": "created"} if role == WRITER else {}
    seen = STATUS | SHOWN if role == READER else {*TABLES, *COUNTING}
    with psycopg.connect(url(plant, role), autocommit=True) as mine:
        mine.execute(f'SET search_path = "{SCHEMA}"')
        for name in (*TABLES, *VIEWS):
            kind = "TABLE" if name in TABLES else "VIEW"
            assert denied(mine, f"SELECT FROM {called(name)}") is (name not in seen), name
            assert denied(mine, f"DROP {kind} {called(name)}")
            assert denied(mine, f"ALTER {kind} {called(name)} RENAME TO mine")
        for name in TABLES:
            assert denied(mine, f"TRUNCATE {called(name)}")
            assert denied(
                mine, f"INSERT INTO {called(name)} SELECT * FROM {called(name)} WHERE false"
            ) is (role == READER or name == "migration")
            assert denied(mine, f"DELETE FROM {called(name)}") is (role == READER or name in KEPT), name
            for (column,) in plant.execute(COLUMNS, [f'"{SCHEMA}".{called(name)}']).fetchall():
                change = f'UPDATE {called(name)} SET "{column}" = NULL WHERE false'
                assert denied(mine, change) is not (written.get(name) == column)
        assert denied(mine, "CREATE TABLE mine (a int)")


@contextmanager
def by_degrees(plant: Any, role: str) -> Iterator[Any]:
    """Take all that the script gave a role, and give it back as it is asked for; yield how."""
    known = sql.Identifier(role)
    plant.execute(
        sql.SQL("REVOKE ALL ON ALL TABLES IN SCHEMA {} FROM {}").format(sql.Identifier(SCHEMA), known)
    )
    given: set[tuple[str, str]] = set()

    def give(said: str) -> None:
        found = re.search(r"GRANT (\w+) ON (?:TABLE|VIEW) (\w+) TO", said)
        assert found, said
        # What changes the rows that a condition finds reads them, too.
        privilege = "SELECT" if (found[1], found[2]) in given else found[1]
        assert (privilege, found[2]) not in given
        given.add((privilege, found[2]))
        grant = sql.SQL("GRANT {} ON {} TO {}")
        plant.execute(grant.format(sql.SQL(privilege), sql.Identifier(SCHEMA, found[2]), known))

    yield give, given


def printed(role: str) -> set[tuple[str, str]]:
    """What the script gives a role, by privilege and table; a column is left out."""
    quoted = role.replace('"', '""')
    lines = re.findall(rf'GRANT (.*) ON TABLE "{SCHEMA}"."(\w+)" TO "{quoted}";', script())
    return {
        (one.partition("(")[0], name) for privileges, name in lines for one in privileges.split(", ")
    }


@pytest.mark.full
def test_a_writer_needs_all_that_is_printed(plant: Any) -> None:
    """Without any, what each refusal names is given until none is left: that is what is printed."""
    administered(plant)
    with by_degrees(plant, WRITER) as (give, given):
        worked(plant, give)
    # Without this one the state is checked all the same, and nobody knows of it.
    # No row of this source is left out, no program is told, and nothing is checked.
    rare = {
        ("INSERT", name)
        for name in ("gam_state_proof", "gam_state_left_out", "gam_state_unknown_program", "gam_program")
    }
    assert printed(WRITER) - given == rare
    assert given <= printed(WRITER)


def test_a_reader_needs_all_that_is_printed(plant: Any) -> None:
    administered(plant)
    worked(plant)
    with by_degrees(plant, READER) as (give, given):
        while (result := gam(plant, READER, "status"))[0] == 1:
            give(result[1])
    assert given == {("SELECT", called(name)) for name in STATUS}
    assert printed(READER) == {("SELECT", called(name)) for name in STATUS | SHOWN}


def test_an_owner_migrates_and_the_script_is_run_again(plant: Any) -> None:
    administered(plant)
    worked(plant)
    before = plant.execute(BUCKETS).fetchall()
    for view in reversed(files()[-1].definitions):
        plant.execute(f'DROP VIEW "{SCHEMA}".{called(view)}')
    plant.execute(f'DELETE FROM "{SCHEMA}".gam_state_migration WHERE number = {len(files())}')
    assert refused(plant, WRITER, "migrate")
    assert gam(plant, OWNER, "migrate")[0] == 0
    assert refused(plant, READER, "alarms")
    administered(plant)
    assert not refused(plant, READER, "alarms")
    assert not refused(plant, WRITER, "score")
    assert plant.execute(BUCKETS).fetchall() == before


@pytest.mark.parametrize(
    "words",
    [
        ("--engine", "postgres", "--grants", "ownr=x"),
        ("--engine", "postgres", "--grants", "owner"),
        ("--engine", "postgres", "--grants", "reader=a,reader=b"),
        ("--engine", "postgres", "--grants", ""),
    ],
)
def test_grants_that_are_none(words: tuple[str, ...]) -> None:
    result = CliRunner().invoke(app, ["migrate", "--sql", *words])
    assert result.exit_code == 1
    assert "write owner=NAME,writer=NAME,reader=NAME" in " ".join(result.output.split())


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--sql", "--engine", "postgres", "--grants", "owner="), "Name at least one of owner, writer"),
        (
            ("--sql", "--engine", "redshift", "--grants", "owner=x"),
            "not for Redshift",
        ),
        (("--grants", "owner=x"), "add --sql"),
    ],
)
def test_grants_that_cannot_be_printed(words: tuple[str, ...], message: str) -> None:
    result = CliRunner().invoke(app, ["migrate", *words])
    assert result.exit_code == 1
    assert message in " ".join(result.output.split())


def test_one_role_alone() -> None:
    only = script("reader=r")
    assert "SET role" not in only
    assert set(re.findall(r"GRANT .* TO (.*);", only)) == {'"r"'}
