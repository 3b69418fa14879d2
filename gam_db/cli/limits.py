"""A limit of time for a command: it is stopped as Ctrl-C stops it, and told apart from that."""

import contextlib
import os
import signal
import threading
from collections.abc import Iterator

from gam_db.errors import ConfigurationError, RunAgainError

#: Seconds after which it is interrupted again: a library may swallow an interrupt while it is imported.
_AGAIN = 5.0


class OutOfTimeError(RunAgainError, code="timeout"):
    """A command took longer than it was given; what counts already stays."""


@contextlib.contextmanager
def limited(seconds: float | None) -> Iterator[None]:
    """Interrupt some work after so many seconds, as :class:`OutOfTimeError`; None for never."""
    if seconds is None or threading.current_thread() is not threading.main_thread():
        yield
        return
    if not hasattr(signal, "setitimer"):
        raise ConfigurationError("--timeout needs a clock that this system does not have.")
    passed = []

    def interrupt(*_: object) -> None:
        passed.append(True)
        os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds, _AGAIN)
    ended: BaseException | None = None
    try:
        yield
    except (KeyboardInterrupt, Exception) as error:
        if not passed:
            raise
        ended = error
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    if passed:  # Typer may have made an exit code of it
        raise OutOfTimeError(
            f"It took longer than --timeout {seconds:g}, and was stopped; nothing was left half "
            "written. Run it again, with more time if need be."
        ) from ended
