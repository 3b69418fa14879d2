"""A full disk ends with 75 and one sentence that says what is full; nothing is half written."""

import errno
import os
import re
import resource
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pyarrow import parquet
from sqlglot import exp
from typer.testing import CliRunner

import gam_db
import harness
from gam_db import data
from gam_db.cli import app
from gam_db.cli.exits import Exit
from gam_db.engines.refusals import refusal
from gam_db.errors import NO_ROOM, FullError, SourceError, unwritable
from gam_db.stored.schema.tables import TABLES
from small_plant import FIRST, readings
from state_names import called

#: The command line in a process of its own.
GAM = (sys.executable, "-c", "from gam_db.cli import main; main()")

METHOD = ("--m", "2", "--tau", "3", "--bins", "4", "--window", "20", "--stride", "5", "--quiet")
ROWS = readings(0, 3 * FIRST)


def invoked(*words: str, room: int | None = None) -> Any:
    """Run a command while no file may grow beyond so many bytes."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (soft if room is None else room, hard))
    try:
        return CliRunner().invoke(app, words)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


def names_what_is_full(answer: Any, what: str) -> None:
    assert answer.exit_code == Exit.RUN_AGAIN, answer.output
    assert re.fullmatch(rf"gam: [^\n]*{what}[^\n]*\.\n", answer.stderr)


@pytest.fixture
def recording(tmp_path: Path) -> str:
    path = tmp_path / "telemetry.parquet"
    parquet.write_table(harness.arrow(ROWS), path)
    return str(path)


@pytest.fixture
def full_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of three megabytes, on which lie files of before and no room."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("left out: no disk may be mounted here; the limit on files stands in for it")
    for name in ("health.parquet", "report.html", "copy.duckdb"):
        (folder / name).write_text("before")
    disk = os.statvfs(folder)
    (folder / "ballast").write_bytes(bytes(disk.f_bavail * disk.f_frsize))
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def counted(database: str) -> dict[str, int]:
    """Return how many rows the tables of a database have."""
    with gam_db.connect(database) as session:
        there = session.relations().keys() & {called(name) for name in TABLES}
        count = exp.select(exp.Count(this=exp.Star()).as_("rows"))
        return {one: session.rows(count.from_(exp.to_table(one)))[0]["rows"] for one in there}


@pytest.mark.parametrize(
    ("address", "what"),
    [
        ("{}/plant.duckdb", "The disk of .* is full"),
        ("sqlite:///{}/plant.db", "The SQLite database, .* full"),
    ],
    ids=["duckdb", "sqlite"],
)
def test_a_database_that_may_not_grow(tmp_path: Path, address: str, what: str) -> None:
    database = address.format(tmp_path)
    with gam_db.connect(database) as session, session.lent(harness.arrow(ROWS)) as lent:
        telemetry = exp.to_table("telemetry")
        session.execute(session.engine.create_table(telemetry, exp.select("*").from_(lent)))
    command = ("calibrate", "telemetry", "--database", database, *METHOD)
    names_what_is_full(invoked(*command, room=40_000), what)
    assert counted(database) == {}, "the tables of the state are there together or not at all"
    assert invoked("migrate", "--database", database).exit_code == Exit.FINE
    before = counted(database)
    names_what_is_full(invoked(*command, room=2_000), what)
    after = counted(database)
    assert {name for name in after if after[name] != before[name]} <= {"gam_state_monitor"}
    assert invoked(*command).exit_code in (Exit.FINE, Exit.ATTENTION)
    assert counted(database)["gam_state_version"] == 4


@pytest.mark.parametrize(
    ("words", "name"),
    [
        (("--out", "{}/health.parquet"), "health.parquet"),
        (("--out", "{}/new.duckdb"), "new.duckdb"),
        (("--no-out", "--report", "{}/report.html"), "report.html"),
    ],
    ids=["parquet", "duckdb", "html"],
)
def test_results_that_find_no_room(
    full_disk: Path, recording: str, words: tuple[str, ...], name: str
) -> None:
    answer = invoked("run", recording, *METHOD, *(word.format(full_disk) for word in words))
    names_what_is_full(answer, rf"{re.escape(name)}.*disk is full")
    there = {one.name for one in full_disk.iterdir()}
    assert there <= {"health.parquet", "report.html", "copy.duckdb", "ballast"}
    assert all((full_disk / one).read_text() == "before" for one in there - {"ballast"})


def test_a_copy_that_finds_no_room(full_disk: Path, tmp_path: Path, recording: str) -> None:
    database = str(tmp_path / "plant.duckdb")
    assert invoked("calibrate", recording, "--database", database, *METHOD).exit_code in (0, 2)
    answer = invoked(
        "score", "--database", database, "--copy", str(full_disk / "copy.duckdb"), "--quiet"
    )
    names_what_is_full(answer, r"copy\.duckdb.*is full")
    assert {one.name for one in full_disk.iterdir()} == {
        *("health.parquet", "report.html", "copy.duckdb", "ballast")
    }
    assert (full_disk / "copy.duckdb").read_text() == "before"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="left out: there is no /dev/full here")
@pytest.mark.parametrize(
    ("words", "what"),
    [
        (("compile", "telemetry", "--engine", "duckdb", "--paper"), "What this command prints"),
        (
            ("compile", "telemetry", "--engine", "duckdb", "--paper", "--out", "/dev/full"),
            "/dev/full",
        ),
    ],
    ids=["printed", "a file"],
)
def test_what_is_printed_finds_no_room(words: tuple[str, ...], what: str) -> None:
    with Path("/dev/full").open("w") as out:
        told = subprocess.run([*GAM, *words], stdout=out, stderr=subprocess.PIPE, text=True, check=False)
    assert told.returncode == Exit.RUN_AGAIN
    assert re.fullmatch(rf"gam: {what}.*\. Make room, and run it again\.\n", told.stderr)


@pytest.mark.parametrize(
    ("of", "said"),
    [
        ("duckdb", 'Could not write file "/x": No space left on device'),
        ("duckdb", 'TransactionContext: Could not write to file "/x": Disk quota exceeded'),
        ("duckdb", "failed to offload data block (limit set by the 'max_temp_directory_size' setting)"),
        ("duckdb_opening", "IO Error: Could not write all bytes to file: No space left on device"),
        ("sqlite", "database or disk is full"),
        ("sqlite", "SQLITE_IOERR_WRITE"),
        ("postgres", "53100"),
        ("mariadb", "1021"),
        ("mariadb", "1114"),
        ("mariadb", 'Error writing file (Errcode: 28 "No space left on device")'),
        ("clickhouse", "243"),
        ("clickhouse", "1001 write: No space left on device"),
        ("spark", "java.io.IOException: No space left on device"),
        ("results", "File too large"),
    ],
)
def test_each_engine_says_that_a_disk_is_full(of: str, said: str) -> None:
    found = refusal(of, said, path="plant", place="plant", address="plant", grant="", name="")
    assert isinstance(found, FullError)
    assert "full" in str(found) or "a quota" in str(found)


@pytest.mark.parametrize(
    ("of", "said"),
    [("sqlite", "disk I/O error"), ("postgres", "58030"), ("duckdb_writing", "IOException")],
)
def test_what_may_have_another_cause_is_not_tried_again(of: str, said: str) -> None:
    found = refusal(of, said)
    assert found is not None
    assert not isinstance(found, FullError)
    assert "is its disk full?" in str(found)


@pytest.mark.parametrize("number", sorted(NO_ROOM))
def test_a_file_that_python_writes(number: int) -> None:
    assert isinstance(unwritable("page.html", OSError(number, "")), FullError)
    other = unwritable("page.html", OSError(errno.EACCES, "Permission denied"), SourceError)
    assert isinstance(other, SourceError)
    assert str(other) == "page.html cannot be written: Permission denied."


def test_a_file_that_is_written_anew_keeps_its_mode_and_its_link(tmp_path: Path) -> None:
    path, link = tmp_path / "script.sql", tmp_path / "link.sql"
    link.symlink_to(path)
    data.put(link, b"one")
    path.chmod(0o600)
    data.put(link, b"two")
    assert path.read_bytes() == b"two"
    assert path.stat().st_mode & 0o777 == 0o600
    assert link.is_symlink()
    assert sorted(file.name for file in tmp_path.iterdir()) == ["link.sql", "script.sql"]
