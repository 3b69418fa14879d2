"""A standalone cluster of Spark on this machine, from the wheel of pyspark: a master and workers."""

import contextlib
import json
import os
import signal
import socket
import subprocess
import time
import urllib.request
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyspark

HOST = "127.0.0.1"
HOME = Path(pyspark.__file__).parent

#: Seconds that a process is given to come up.
PATIENCE = 120


@dataclass
class Cluster:
    """A cluster at work.

    Attributes:
        master: ``HOST:PORT``.
        page: of the master, which answers in JSON.
        workers: its processes.
    """

    master: str
    page: str
    workers: list[subprocess.Popen[bytes]]

    def alive(self) -> int:
        """Return how many workers the master counts on."""
        with urllib.request.urlopen(f"{self.page}/json/", timeout=5) as answer:
            told: dict[str, Any] = json.load(answer)
        return int(told["aliveworkers"])

    def kill(self, number: int) -> None:
        """Kill a worker and its executors, at once."""
        os.killpg(self.workers[number].pid, signal.SIGKILL)
        self.workers[number].wait()


@contextlib.contextmanager
def cluster(folder: Path, workers: int = 2, cores: int = 1, memory: str = "1g") -> Iterator[Cluster]:
    """Start a cluster, and end it afterwards.

    Args:
        folder: for logs and working files.
        workers: how many.
        cores: of each.
        memory: of each, for its executors.
    """
    port, page = _free_port(), _free_port()
    master = f"{HOST}:{port}"
    place = ["--host", HOST]
    serving = [_start("master.Master", folder, *place, "--port", port, "--webui-port", page)]
    made = Cluster(master, f"http://{HOST}:{page}", [])
    try:
        _until(lambda: made.alive() == 0)
        for number in range(workers):
            own = ["--cores", str(cores), "--memory", memory, "--webui-port", _free_port()]
            work = ["--work-dir", str(folder / f"worker_{number}"), f"spark://{master}"]
            made.workers.append(_start("worker.Worker", folder, *place, *own, *work))
        _until(lambda: made.alive() == workers)
        yield made
    finally:
        for process in (*made.workers, *serving):
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def _start(name: str, folder: Path, *arguments: str) -> subprocess.Popen[bytes]:
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / f"{name}.log").open("ab") as log:
        return subprocess.Popen(
            [str(HOME / "bin" / "spark-class"), f"org.apache.spark.deploy.{name}", *arguments],
            stdout=log,
            stderr=log,
            env={**os.environ, "SPARK_LOCAL_IP": HOST, "SPARK_NO_DAEMONIZE": "1"},
            start_new_session=True,
        )


def _free_port() -> str:
    with socket.socket() as found:
        found.bind((HOST, 0))
        return str(found.getsockname()[1])


def _until(ready: Any) -> None:
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        with contextlib.suppress(OSError, ValueError):  # it says so before it can answer
            if ready():
                return
        time.sleep(0.2)
    raise TimeoutError("the cluster did not come up")
