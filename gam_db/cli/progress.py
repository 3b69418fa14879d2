"""Progress: a status line on stderr while a study works, and a clean end when it is interrupted.

This module owns the line; ``stages.toml`` has the words of each step.
"""

import contextlib
import re
import signal
import threading
import time
from collections.abc import Iterator, Mapping
from functools import cache
from types import FrameType

from rich.console import Console, RenderableType
from rich.status import Status

from gam_db import data
from gam_db.composing.template import sql_folder
from gam_db.engines.session import Session
from gam_db.study.running import Listener

EVERY = 60.0
"""Seconds between two lines of progress in a log."""


def stage(step: str) -> str:
    """Return a step in words that a user knows; a step that is words already stays."""
    return step if " " in step else _stages().get(re.sub(r"(_\d+)+$", "", step), "working")


@cache
def _stages() -> Mapping[str, str]:
    words = data.table("gam_db.cli", "stages.toml")
    stages = dict(words["names"])
    for folder, text in words["folders"].items():
        for path in (sql_folder() / folder).glob("*.sql"):
            stages.setdefault(path.stem, text)
    return stages


class Progress:
    """A status line: the stage at work, for how long, and how far DuckDB says its statement is.

    Where stderr is no terminal, a run prints such a line once a minute.
    """

    def __init__(self, session: Session, quiet: bool = False) -> None:
        self._console, self._session = Console(stderr=True), session
        self._stage = "reading the source"
        self._since = self._begin = time.monotonic()
        shown = self._console.is_terminal and not quiet
        self._status = Status(self, console=self._console, refresh_per_second=5) if shown else None
        self._is_logged = not (shown or quiet)
        self._ended = threading.Event()
        self._logging = threading.Thread(target=self._log, daemon=True)

    def __enter__(self) -> "Progress":
        if self._status:
            self._status.start()
        elif self._is_logged:
            self._logging.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        if self._status:
            self._status.stop()
        elif self._is_logged:
            self._logging.join()  # drivers complain at the end of a process of what a thread still holds

    def _log(self) -> None:
        while not self._ended.wait(EVERY):
            with contextlib.suppress(OSError, ValueError):  # the log may be gone
                self._console.print(self.__rich__(), soft_wrap=True, highlight=False)

    def on_step(self, step: str) -> None:
        """Take note of the step that begins."""
        if (now_at := stage(step)) != self._stage:
            self._stage, self._since = now_at, time.monotonic()

    def __rich__(self) -> RenderableType:
        now = time.monotonic()
        line = f"{self._stage}  {now - self._since:.0f} s"
        with contextlib.suppress(Exception):  # a line of comfort must not end the work
            percent = self._session.progress()
            if 0 < percent < 100:
                line += f", {percent:.0f} %"
        return f"{line}  (total {now - self._begin:.0f} s)"


@contextlib.contextmanager
def interruptible() -> Iterator[None]:
    """Let Ctrl-C end the work as KeyboardInterrupt, whatever error came of it.

    Cause: DuckDB notices the signal inside a statement, stops it, and raises an error of its own in
    the place of KeyboardInterrupt. Symptom: Ctrl-C looks like a fault.
    """
    pressed: list[int] = []

    def note(number: int, _: FrameType | None) -> None:
        pressed.append(number)
        raise KeyboardInterrupt

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGINT, note)
    try:
        yield
    except Exception as error:
        if pressed:
            raise KeyboardInterrupt from error
        raise
    finally:
        signal.signal(signal.SIGINT, before)


@contextlib.contextmanager
def working(session: Session, quiet: bool = False) -> Iterator[Listener]:
    """Show progress during some work and close the session after it; yields the listener of steps."""
    with interruptible(), session, Progress(session, quiet) as progress:
        yield progress.on_step
