"""The command line: ``gam``. Commands are thin: parse, call, print.

This module owns the list of commands, how errors are told, and the exit codes:

* 0: done, and nothing needs attention,
* 1: something the user can mend; one paragraph on stderr says what,
* 2: done, and a channel needs attention (see :mod:`gam_db.findings`),
* 3: our fault,
* 75: another writer was faster; run it again,
* 130: interrupted.
"""

import sys
import traceback
from collections.abc import Sequence
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from gam_db.address import without_passwords
from gam_db.cli import commands
from gam_db.errors import ConflictError, StatementError, UserError
from gam_db.version import __version__

FINE, USER_ERROR, OUR_FAULT, RUN_AGAIN, INTERRUPTED = 0, 1, 3, 75, 130

#: What Typer raises for options it cannot parse; it does not export the name.
_UsageError: type[Exception] = typer.BadParameter.__bases__[0]


class Commands(TyperGroup):
    """The commands, with our exit codes, and with ``--debug`` wherever it stands.

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

    def main(self, args: Sequence[str] | None = None, *more: Any, **named: Any) -> Any:
        """Run one command and end the process with its exit code."""
        named.setdefault("prog_name", "gam")
        words = list(sys.argv[1:] if args is None else args)
        debug = "--debug" in words
        for stream in (sys.stdout, sys.stderr):
            if hasattr(stream, "reconfigure"):  # names of machines may not fit the terminal's alphabet
                stream.reconfigure(errors="backslashreplace")
        try:
            named["standalone_mode"] = False  # or Typer would end the process itself, its own way
            code = super().main([word for word in words if word != "--debug"], *more, **named)
        except Exception as error:
            code = _told(error, debug)
        except KeyboardInterrupt:
            code = INTERRUPTED
        if code == INTERRUPTED:
            print("gam: interrupted; no file was left half written.", file=sys.stderr)
        sys.exit(code if isinstance(code, int) else FINE)


app = typer.Typer(
    cls=Commands,
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"]},
    help="A health indicator for every machine channel, computed where the telemetry lies.",
    epilog="Exit codes: 0 fine, 1 something for you to mend, 2 a channel needs attention, 3 our fault, "
    "75 another writer was faster: run it again.",
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"gam-db {__version__}")
        raise typer.Exit


@app.callback()
def of_every_command(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", callback=_version, is_eager=True)
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="With any command: show the traceback of an error.")
    ] = False,
) -> None:
    """Take the options of every command; ``--debug`` was taken by :class:`Commands`."""


def main() -> None:
    """Run the command line."""
    app()


def _told(error: Exception, debug: bool) -> int:
    """Tell an error on stderr and return the exit code it means."""
    if isinstance(error, typer.Abort):
        return INTERRUPTED
    if debug:
        print(without_passwords("".join(traceback.format_exception(error))), file=sys.stderr)
        if isinstance(error, StatementError) and error.statement:
            print(f"\nThe statement was:\n{error.statement}\n", file=sys.stderr)
    if isinstance(error, _UsageError):
        error.message = without_passwords(error.message)  # type: ignore[attr-defined]
        error.show()  # type: ignore[attr-defined]
        return USER_ERROR
    if isinstance(error, UserError):
        print(f"gam: {without_passwords(str(error))}", file=sys.stderr)
        return RUN_AGAIN if isinstance(error, ConflictError) else USER_ERROR
    first = without_passwords(str(error)).partition("\n")[0]
    kind = "" if type(error).__module__.startswith("gam_db") else f"{type(error).__name__}: "
    print(
        f"gam: this is a fault of gam-db, not yours. {kind}{first} "
        + ("Please report it." if debug else "Run it again with --debug for all of it, to report it."),
        file=sys.stderr,
    )
    return OUR_FAULT
