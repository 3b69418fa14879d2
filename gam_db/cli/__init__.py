"""The command line: ``gam``. Commands are thin: parse, call, print.

A module of commands owns them and their pages; what they print is found out below. This one owns how
errors are told, and how long a command may take: it is stopped as Ctrl-C would, but told apart from it.
"""

import contextlib
import json
import os
import signal
import sys
import textwrap
import threading
import time
import traceback
from collections.abc import Iterator, Sequence
from typing import Any

import typer
from typer.core import TyperGroup

from gam_db.address import without_passwords
from gam_db.cli import commands
from gam_db.cli.exits import MEANINGS, Exit
from gam_db.errors import (
    NO_ROOM,
    ConfigurationError,
    InternalError,
    RunAgainError,
    StatementError,
    UserError,
    printable,
    unwritable,
)
from gam_db.extras import begin_process
from gam_db.version import __version__

#: What Typer raises for options it cannot parse; it does not export the name.
_UsageError: type[Exception] = typer.BadParameter.__bases__[0]


#: Seconds before a command is tried again: twice as long each time, up to the longest.
_PAUSE, _LONGEST_PAUSE = 1.0, 60.0

#: Seconds after which it is interrupted again: a library may swallow an interrupt while it is imported.
_INTERRUPTED_AGAIN = 5.0


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
    signal.setitimer(signal.ITIMER_REAL, seconds, _INTERRUPTED_AGAIN)
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


class Commands(TyperGroup):
    """The commands, with our exit codes, and with the options of all of them wherever they stand.

    A command is imported when it is run; until then a stand-in tells its name and what it does.
    """

    def __init__(self, **attributes: Any) -> None:
        super().__init__(**attributes)
        for stand_in in commands.listed():
            self.add_command(stand_in)

    def resolve_command(self, ctx: Any, args: list[str]) -> tuple[str | None, Any, list[str]]:
        """Import the command that is asked for."""
        name, stand_in, rest = super().resolve_command(ctx, args)
        return name, stand_in and commands.loaded(str(name)), rest

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Write the help of ``gam`` on one screen: a line per command, without boxes."""
        panels: dict[str, list[tuple[str, str]]] = {}
        for name, stand_in in self.commands.items():
            panel = str(getattr(stand_in, "rich_help_panel", ""))
            panels.setdefault(panel, []).append((name, stand_in.help or ""))
        options = [record for option in self.get_params(ctx) if (record := option.get_help_record(ctx))]
        formatter.write(f"Usage: {ctx.command_path} COMMAND [OPTIONS]; see also gam COMMAND --help\n\n")
        formatter.write(f"{self.help}\n\n")
        for panel, lines in (panels | {"Options": options}).items():
            width = max(len(name) for name, _ in lines)
            formatter.write(f"{panel}:\n")
            formatter.write("".join(f"  {name:{width}}  {text}\n" for name, text in lines))
        formatter.write(f"\n{self.epilog}")

    def main(self, args: Sequence[str] | None = None, *more: Any, **named: Any) -> Any:
        """Run one command and end the process with its exit code."""
        named.setdefault("prog_name", "gam")
        named["standalone_mode"] = False  # or Typer would end the process itself, its own way
        for stream in (sys.stdout, sys.stderr):
            if hasattr(stream, "reconfigure"):  # names of machines may not fit the terminal's alphabet
                stream.reconfigure(errors="backslashreplace")
        arguments = list(sys.argv[1:] if args is None else args)
        debug, as_json = "--debug" in arguments, "--json" in arguments
        try:
            words, retry = _taken([word for word in arguments if word != "--debug"], "--retry", int)
            words, seconds = _taken(words, "--timeout", float)
        except ConfigurationError as error:
            sys.exit(_print_error(error, debug, as_json))
        for turn in range(int(retry or 0) + 1):
            try:
                with limited(seconds):
                    code = super().main(words, *more, **named)
            except RunAgainError as error:
                if turn < int(retry or 0):
                    print(f"gam: {_legible(error.options)} Trying again.", file=sys.stderr)
                    time.sleep(min(_PAUSE * 2**turn, _LONGEST_PAUSE))
                    continue
                code = _print_error(error, debug, as_json)
            except Exception as error:
                code = _print_error(_of_user(error), debug, as_json)
            except KeyboardInterrupt:
                code = Exit.INTERRUPTED
            break
        try:
            sys.stdout.flush()
        except OSError as error:
            if error.errno in NO_ROOM:
                code = _print_error(_of_user(error), debug, False)
        if code == Exit.INTERRUPTED:
            print("gam: interrupted; no file was left half written.", file=sys.stderr)
        sys.exit(code if isinstance(code, int) else Exit.FINE)


def _taken(
    words: list[str], option: str, kind: type[int] | type[float]
) -> tuple[list[str], float | None]:
    """Return the words without an option of all commands, and its value; None where it is not there.

    Raises:
        ConfigurationError: its value is no positive number.
    """
    left: list[str] = []
    value: float | None = None
    rest = iter(words)
    for word in rest:
        name, equals, text = word.partition("=")
        if name != option:
            left.append(word)
            continue
        text = text if equals else next(rest, "")
        try:
            value = kind(text)
        except ValueError:
            value = None
        if value is None or not 0 < value < float("inf"):
            raise ConfigurationError(f"{option} is {text!r}; it takes a positive number, such as 3.")
    return left, value


app = typer.Typer(
    cls=Commands,
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Compute a health indicator for every machine signal, where the data is.",
    epilog="\n".join(
        textwrap.wrap(
            f"Exit codes: {', '.join(f'{code:d} {text}' for code, text in MEANINGS.items())}.", 76
        )
    ),
)


def _version(context: typer.Context, wanted: bool) -> None:
    if wanted:
        from gam_db.cli import installed  # no other command needs what it imports

        more = installed.lines() if context.params["verbose"] else ()
        typer.echo("\n".join((f"gam-db {__version__}", *more)))
        raise typer.Exit


@app.callback()
def of_every_command(
    version: bool = typer.Option(
        False,
        "--version",
        help="Print the version; with --verbose also of libraries.",
        callback=_version,
    ),
    verbose: bool = typer.Option(
        False, "--verbose", help="With --version only.", is_eager=True, hidden=True
    ),
    debug: bool = typer.Option(False, "--debug", help="Show the traceback of an error."),
    retry: int | None = typer.Option(
        None,
        metavar="N",
        help="Run a command that ends with 75 again, up to N times.",
    ),
    timeout: float | None = typer.Option(
        None,
        metavar="SECONDS",
        help="Stop a command after this time and end with 75.",
    ),
) -> None:
    """Read the options of every command; :class:`Commands` has read ``--debug`` and the next ones.

    Raises:
        ConfigurationError: ``--verbose`` stands without ``--version``.
    """
    if verbose:
        raise ConfigurationError("--verbose goes with --version.")


def main() -> None:
    """Run the command line."""
    begin_process()
    app()


def _of_user(error: Exception) -> Exception:
    """Return the error for the user where a file, or what is printed, found no room."""
    if not isinstance(error, OSError) or error.errno not in NO_ROOM:
        return error
    if error.filename is None:
        # Python would try again to print it, at its end, and change the exit code.
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return unwritable(error.filename or "What this command prints", error)


def _print_error(error: Exception, debug: bool, as_json: bool) -> int:
    """Tell an error on stderr, for --json as an object on stdout, too; return the exit code it means."""
    if isinstance(error, typer.Abort):
        return Exit.INTERRUPTED
    if debug:
        print(without_passwords("".join(traceback.format_exception(error))), file=sys.stderr)
        if isinstance(error, StatementError) and error.statement:
            print(f"\nThe statement was:\n{error.statement}\n", file=sys.stderr)
    is_usage = isinstance(error, _UsageError)
    text = error.options if isinstance(error, UserError) else str(error)
    if is_usage:
        text = error.message  # type: ignore[attr-defined]
    message = _legible(text)
    exit_code = Exit.OUR_FAULT
    if is_usage or isinstance(error, UserError):
        exit_code = Exit.RUN_AGAIN if isinstance(error, RunAgainError) else Exit.USER_ERROR
    if exit_code == Exit.OUR_FAULT:
        kind = "" if type(error).__module__.startswith("gam_db") else f"{type(error).__name__}: "
        message = f"this is a fault of gam-db, not yours. {kind}{message.partition(chr(10))[0]} " + (
            "Please report it." if debug else "Run it again with --debug for all of it, to report it."
        )
    if as_json:
        code = "usage" if is_usage else getattr(error, "code", InternalError.code)
        error_report = {"version": __version__, "error": {"code": code, "message": message}}
        print(json.dumps({**error_report, "exit_code": int(exit_code)}, indent=1))
    if is_usage:
        error.message = message  # type: ignore[attr-defined]
        error.show()  # type: ignore[attr-defined]
    else:
        print(f"gam: {message}", file=sys.stderr)
    return exit_code


def _legible(text: str) -> str:
    """Return the lines of a message without passwords, and without signs that a terminal would obey."""
    return "\n".join(map(printable, without_passwords(text).split("\n")))
