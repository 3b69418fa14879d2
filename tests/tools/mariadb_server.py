"""A throw-away MariaDB server, for as long as the tests of one process run.

It is started once (``server()``), listens on a free port of this machine, lets root in without a
password, keeps nothing safe from a crash, and is wiped when the process ends.
"""

import atexit
import functools
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from postgres_server import free_port

#: Seconds that it may take to start.
PATIENCE = 60


@functools.cache
def server() -> str:
    """Start the server of this process, and return the address of its database *plant*.

    Raises:
        RuntimeError: MariaDB is not installed, or does not start; the message ends with its log.
    """
    install, program = shutil.which("mariadb-install-db"), shutil.which("mariadbd")
    if install is None or program is None:
        raise RuntimeError("MariaDB is not installed (Debian: apt-get install mariadb-server).")
    folder = Path(tempfile.mkdtemp(prefix="gam_mariadb_", dir="/tmp"))  # a socket's path is short
    user = ["--user=mysql"] if os.geteuid() == 0 else []
    if user:
        shutil.chown(folder, "mysql")
    made = [install, "--no-defaults", *user, f"--datadir={folder}/data", "--skip-test-db"]
    made.append("--auth-root-authentication-method=normal")
    port = free_port()
    (folder / "begin.sql").write_text("CREATE DATABASE plant;\n")
    # A server that starts removes the temporary tables of all others in its folder of temporary files.
    scratch = folder / "scratch"
    scratch.mkdir()
    if user:
        shutil.chown(scratch, "mysql")
    words = [
        *(program, "--no-defaults", *user, f"--datadir={folder}/data", f"--socket={folder}/socket"),
        *(f"--port={port}", "--bind-address=127.0.0.1", f"--init-file={folder}/begin.sql"),
        *("--innodb-flush-log-at-trx-commit=0", "--innodb-flush-method=nosync"),
        *(f"--tmpdir={scratch}", "--skip-name-resolve"),
        *("--innodb-buffer-pool-size=64M", "--innodb-log-file-size=16M"),
    ]
    with (folder / "log").open("wb") as log:
        subprocess.run(made, stdout=log, stderr=log, check=True)
        running = subprocess.Popen(words, stdout=log, stderr=log, start_new_session=True)
    atexit.register(_stop, running, folder)
    _watch(running.pid, folder)
    until = time.monotonic() + PATIENCE
    while not _answers(port):
        if running.poll() is not None or time.monotonic() > until:
            said = (folder / "log").read_text(errors="replace")
            raise RuntimeError(f"MariaDB did not start: {said[-2000:]}")
        time.sleep(0.1)
    return f"mariadb://root@127.0.0.1:{port}/plant"


def version() -> str:
    """Return the version of MariaDB, without what Debian adds."""
    program = shutil.which("mariadbd")
    assert program is not None
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    return said.partition("Ver ")[2].partition("-")[0]


def _answers(port: int) -> bool:
    import pymysql

    try:
        pymysql.connect(host="127.0.0.1", port=port, user="root", database="plant").close()
    except pymysql.err.MySQLError:
        return False
    return True


def _stop(running: "subprocess.Popen[bytes]", folder: Path) -> None:
    if running.poll() is not None:  # it was not we who ended it
        print((folder / "log").read_text(errors="replace")[-4000:], file=sys.stderr)
    running.kill()
    running.wait()
    shutil.rmtree(folder, ignore_errors=True)


def _watch(server: int, folder: Path) -> None:
    """Stop the server even if this process is killed: a shell, nobody's child, waits for its end."""
    end = f"kill -9 {server}; rm -rf {shlex.quote(str(folder))}"
    script = f"(while kill -0 {os.getpid()}; do sleep 2; done; {end}) </dev/null >/dev/null 2>&1 &"
    subprocess.run(["sh", "-c", script], start_new_session=True, cwd="/", check=True)
