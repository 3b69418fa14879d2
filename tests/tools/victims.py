"""Processes that are made to be killed: each runs one command on a database file.

Run as a program it loads gam_db once and then forks a child for every order that it reads, which takes
milliseconds instead of a second. It never opens a database itself: only a child does, so that no thread
or lock of DuckDB is ever shared by a fork.

An order and its answer are one line of JSON each. An order says

    database, command ("migrate", "calibrate", "score" or "label")
    parameters, calibration, options   keyword arguments of the monitor and of the command
    step, delay                        when to kill: so many seconds after the so-manieth step was
                                       announced (1: the file is open); at once if delay is 0

and the answer is the exit code of the child, -9 for one that was killed, and how many seconds it lived
after its file was open.
"""

import gc
import io
import json
import os
import select
import signal
import subprocess
import sys
import time
import traceback
from dataclasses import dataclass
from typing import Any

import gam_db
import harness
import tiny
from gam_db.composing import template
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.schema.migration_files import files
from gam_db.study.running import Listener

#: A child that takes longer hangs, and ends itself.
PATIENCE = 120


@dataclass(frozen=True)
class Moment:
    """When a process is to die: ``delay`` seconds after its ``step``-th announcement."""

    step: int
    delay: float = 0.0


class Victims:
    """The program below at work, or another one like it.

    Attributes:
        killed: how many processes were hit.
    """

    def __init__(self, program: str = __file__) -> None:
        self.killed = 0
        paths = os.pathsep.join(path for path in sys.path if path)
        self._server = subprocess.Popen(
            [sys.executable, program],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": paths},
        )

    def kill(self, moment: Moment, **order: Any) -> bool:
        """Start a command and kill it; return whether it was still running at that moment."""
        code, _ = self._ask({**order, "step": moment.step, "delay": moment.delay})
        assert code in (0, -signal.SIGKILL), f"{order} ended with {code} by itself"
        self.killed += code != 0
        return bool(code)

    def lifetime(self, **order: Any) -> float:
        """Run a command to its end and return how long that takes, from when the file is open."""
        code, seconds = self._ask({**order, "step": 1, "delay": PATIENCE})
        assert code == 0, f"{order} ended with {code} by itself"
        return seconds

    def _ask(self, order: dict[str, Any]) -> tuple[int, float]:
        asked, told = self._server.stdin, self._server.stdout
        assert asked is not None
        assert told is not None
        asked.write(json.dumps(order) + "\n")
        asked.flush()
        code, seconds = json.loads(told.readline())
        return code, seconds

    def close(self) -> None:
        """End the program."""
        self._server.communicate()


def serve() -> None:
    """Do what is ordered on standard input, until it is closed."""
    warm()
    for line in sys.stdin:
        print(json.dumps(fate(json.loads(line))), flush=True)


def warm() -> None:
    """Parse what every child would parse, and take what other tests take for granted."""
    tiny.judge_any_calibration()
    files()
    folder = template.sql_folder()
    for path in folder.rglob("*.sql"):
        template.load(str(path.relative_to(folder).with_suffix("")))
    # No child walks again and again through what is parsed here, nor soon through what it makes itself.
    gc.collect()
    gc.freeze()
    gc.set_threshold(1_000_000, 20, 100)


def fate(order: dict[str, Any]) -> tuple[int, float]:
    """Let a child do what is ordered, kill it in time; return its exit code and its lifetime."""
    heard, said = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(heard)
        signal.alarm(PATIENCE)
        try:
            live(order, said)
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        os._exit(0)
    os.close(said)
    with open(heard, "rb", buffering=0) as steps:
        steps.readline()
        began = time.perf_counter()
        if is_at_work(steps, order["step"] - 1, order["delay"]):
            os.kill(child, signal.SIGKILL)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return code, time.perf_counter() - began


def is_at_work(steps: io.FileIO, more: int, delay: float) -> bool:
    """Wait for so many more steps and so many seconds; tell whether the child is still there.

    Nothing is said any more once it has ended, so its moment need not be waited for.
    """
    if not all(steps.readline() for _ in range(more)):
        return False
    moment = time.perf_counter() + delay
    while (left := moment - time.perf_counter()) > 0:
        if select.select([steps], [], [], left)[0] and not steps.read(4096):
            return False
    return True


def live(order: dict[str, Any], said: int) -> None:
    """Run a command, and die on the spot where no delay is asked for."""
    announced = 0

    def announce(step: str) -> None:
        nonlocal announced
        announced += 1
        os.write(said, f"{step}\n".encode())
        if announced == order["step"] and not order["delay"]:
            os.kill(os.getpid(), signal.SIGKILL)

    with gam_db.connect(order["database"], threads=1) as session:
        announce("open")
        parameters, calibration = harness.made(order["parameters"], order["calibration"])
        source = gam_db.Source("telemetry")
        asked = gam_db.Alarms(order.get("alarms"))
        monitor = Monitor(session, source, parameters, calibration, asked, lookback=order["lookback"])
        carry_out(monitor, order["command"], order["options"], announce)


def carry_out(monitor: Monitor, command: str, options: dict[str, Any], on_step: Listener) -> None:
    """Run a command of a monitor, and listen."""
    if command == "migrate":
        migrations.migrate(monitor.session, monitor.state.tables, on_step)
    elif command == "label":
        for one in options["labels"]:
            on_step(command)
            monitor.label(**one)
    else:
        getattr(monitor, command)(on_step=on_step, **options)


if __name__ == "__main__":
    serve()
