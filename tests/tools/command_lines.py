"""The command lines of databases that execute a script, as docs/schedule.md has them."""

import subprocess
import sys
from pathlib import Path
from urllib.parse import urlsplit

import duckdb

import mariadb_server
import postgres_server
from gam_db.engines.connecting import connect
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session

#: What stands for DuckDB's command line where only its Python is installed.
OF_DUCKDB = "import sys, duckdb; duckdb.connect(sys.argv[1]).execute(open(sys.argv[2]).read())"


def opened(engine: str, folder: Path) -> Session:
    """Return a session on a database that a command line can reach, too."""
    if engine == "duckdb":
        return DuckSession(duckdb.connect(str(folder / "plant.duckdb")))
    if engine == "sqlite":
        return connect(f"sqlite:///{folder / 'plant.db'}")
    return connect(postgres_server.server().url if engine == "postgres" else mariadb_server.server())


def words(engine: str, folder: Path, script: Path) -> list[str]:
    """Return the command line that executes a script on that database; SQLite and MariaDB read it."""
    if engine == "duckdb":
        return [sys.executable, "-c", OF_DUCKDB, str(folder / "plant.duckdb"), str(script)]
    if engine == "sqlite":
        return ["sqlite3", str(folder / "plant.db")]
    if engine == "postgres":
        return ["psql", "-X", "-d", postgres_server.server().url, "-f", str(script)]
    place = urlsplit(mariadb_server.server())
    asked = [f"--host={place.hostname}", f"--port={place.port}", f"--user={place.username}"]
    return ["mariadb", "--no-defaults", *asked, place.path.strip("/")]


def executed(
    engine: str, folder: Path, session: Session, text: str
) -> subprocess.CompletedProcess[bytes]:
    """Execute a script; on DuckDB by another connection, since one process at a time opens a file."""
    if engine == "duckdb":
        assert isinstance(session, DuckSession)
        with session.connection.cursor() as connection:
            try:
                connection.execute(text)
            except duckdb.Error as error:
                return subprocess.CompletedProcess([], 1, b"", str(error).encode())
        return subprocess.CompletedProcess([], 0, b"", b"")
    script = folder / "run.sql"
    script.write_text(text, encoding="utf-8")
    with script.open("rb") as read:
        return subprocess.run(words(engine, folder, script), stdin=read, capture_output=True)
