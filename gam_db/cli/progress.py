"""Progress: a status line on stderr while a study works, and a clean end when it is interrupted.

This module owns what is shown meanwhile; it computes nothing.
"""

import contextlib
import signal
import threading
import time
from collections.abc import Iterator
from types import FrameType

from rich.console import Console, RenderableType
from rich.status import Status

from gam_db.engines.session import Session
from gam_db.study.running import Listener

EVERY = 30.0
"""Seconds after which a run that writes into a log says what it does, and then again."""


class Progress:
    """A status line: the step at work, for how long, and how far DuckDB says it is.

    Where stderr is no terminal, a run prints a line at each step once it lasts 30 s, and one every 30 s.
    """

    def __init__(self, session: Session, quiet: bool = False) -> None:
        self._console, self._session = Console(stderr=True), session
        self._step = "looking at the source"
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
            self._tell()

    def _tell(self) -> None:
        with contextlib.suppress(OSError, ValueError):  # the log may be gone
            self._console.print(self.__rich__(), soft_wrap=True, highlight=False)

    def on_step(self, step: str) -> None:
        """Take note of the step that begins."""
        self._step = step
        self._since = time.monotonic()
        if self._is_logged and self._since - self._begin >= EVERY:
            self._tell()

    def __rich__(self) -> RenderableType:
        now = time.monotonic()
        line = f"{self._step}  {now - self._since:.0f} s"
        with contextlib.suppress(Exception):  # a line of comfort must not end the work
            percent = self._session.progress()
            if 0 < percent < 100:
                line += f", {percent:.0f} %"
        return f"{line}  (in all {now - self._begin:.0f} s)"


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
    """Close a session after some work, and show meanwhile what is done; yields what is told the step."""
    with interruptible(), session, Progress(session, quiet) as progress:
        yield progress.on_step
