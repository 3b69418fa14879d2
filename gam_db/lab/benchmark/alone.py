"""A process of its own for every measured run, and what it used."""

import json
import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import gam_db
from gam_db.errors import GamError, InternalError
from gam_db.extras import begin_process, hide_pandas

#: How the tasks begin that another program does, which is measured beside gam-db.
_NOT_OURS = ("extract", "floor")


def run(module: str, task: str, job: str) -> dict[str, Any]:
    """Run a module of this package in a fresh process and return the figures that it printed last.

    Args:
        module: its name in ``gam_db.lab.benchmark``.
        task: what it does, for the message.
        job: its only argument.

    Raises:
        InternalError: it failed; the message is the last line that it wrote.
    """
    # The package may have been imported from a folder that a new interpreter would not search.
    paths = [str(Path(gam_db.__file__).parent.parent), os.environ.get("PYTHONPATH", "")]
    finished = subprocess.run(
        [sys.executable, "-m", f"gam_db.lab.benchmark.{module}", job],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, paths))},
    )
    if finished.returncode:
        last = finished.stderr.strip().rpartition("\n")[2]
        raise InternalError(f"The benchmark's {task} failed: {last}")
    figures: dict[str, Any] = json.loads(finished.stdout.strip().rpartition("\n")[2])
    return figures


def answer(work: Callable[[str], Mapping[str, Any]]) -> None:
    """Do the job that this process was started for, and print its figures as the last line.

    Ours begins as a command does. A script or a floor begins as Python does, with its collector as it
    is; but it loads no pandas either, since imports are not measured.
    """
    if json.loads(sys.argv[1])["task"].startswith(_NOT_OURS):
        hide_pandas()
    else:
        begin_process()
    try:
        print(json.dumps(work(sys.argv[1])))
    except GamError as error:
        sys.exit(str(error))


def measured(work: Callable[[], Mapping[str, Any] | None], server: str = "") -> dict[str, Any]:
    """Do some work; return what it found, and what it took.

    Args:
        work: what to do.
        server: of which engine the processes count as well, where there are such on this machine.

    Returns:
        Besides what was found: ``seconds``; ``processor_seconds`` of all threads, of the processes that
        this one started, and of the server, which a busy machine changes less; ``peak_memory`` of the
        process in MiB.
    """
    started, used = time.perf_counter(), _processor_seconds(server)
    figures = dict(work() or {})
    figures["seconds"] = time.perf_counter() - started
    figures["processor_seconds"] = _processor_seconds(server) - used
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    figures["peak_memory"] = peak / 2**20 if sys.platform == "darwin" else peak / 2**10
    return figures


def _processor_seconds(server: str) -> float:
    """Return what this process, those it started, and those of a server have used so far.

    Of others than this one only Linux tells.
    """
    processor_time = time.process_time()
    parents: dict[int, int] = {}
    used: dict[int, float] = {}
    of_server = set()
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            head, _, rest = path.read_text(encoding="utf-8", errors="replace").rpartition(")")
        except OSError:  # it has ended meanwhile
            continue
        number, name = head.split(" (", 1)
        figures = rest.split()
        parents[int(number)] = int(figures[1])
        # Of its own, and of its children that have ended.
        used[int(number)] = sum(map(int, figures[11:15])) / os.sysconf("SC_CLK_TCK")
        if server and name == server:
            of_server.add(int(number))
    mine = os.getpid()
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    counted = {process for process in parents if _descends(process, mine, parents)} | of_server
    return processor_time + ended.ru_utime + ended.ru_stime + sum(used[process] for process in counted)


def _descends(process: int, ancestor: int, parents: Mapping[int, int]) -> bool:
    while (process := parents.get(process, 0)) > 0:
        if process == ancestor:
            return True
    return False
