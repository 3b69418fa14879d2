"""The command line: ``gam``. Commands are thin: parse, call, print.

This module owns how errors are told.
"""

import sys
import traceback
from collections.abc import Sequence
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from gam_db.address import without_passwords
from gam_db.cli import commands
from gam_db.cli.exits import MEANINGS, Exit
from gam_db.errors import ConflictError, StatementError, UserError
from gam_db.version import __version__

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
            code = Exit.INTERRUPTED
        if code == Exit.INTERRUPTED:
            print("gam: interrupted; no file was left half written.", file=sys.stderr)
        sys.exit(code if isinstance(code, int) else Exit.FINE)


app = typer.Typer(
    cls=Commands,
    add_completion=False,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode="markdown",
    context_settings={"help_option_names": ["-h", "--help"]},
    help="A health indicator for every machine channel, computed where the telemetry lies.",
    epilog=f"Exit codes: {', '.join(f'{code:d} {meaning}' for code, meaning in MEANINGS.items())}.",
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
        return Exit.INTERRUPTED
    if debug:
        print(without_passwords("".join(traceback.format_exception(error))), file=sys.stderr)
        if isinstance(error, StatementError) and error.statement:
            print(f"\nThe statement was:\n{error.statement}\n", file=sys.stderr)
    if isinstance(error, _UsageError):
        error.message = without_passwords(error.message)  # type: ignore[attr-defined]
        error.show()  # type: ignore[attr-defined]
        return Exit.USER_ERROR
    if isinstance(error, UserError):
        print(f"gam: {without_passwords(str(error))}", file=sys.stderr)
        return Exit.RUN_AGAIN if isinstance(error, ConflictError) else Exit.USER_ERROR
    first = without_passwords(str(error)).partition("\n")[0]
    kind = "" if type(error).__module__.startswith("gam_db") else f"{type(error).__name__}: "
    print(
        f"gam: this is a fault of gam-db, not yours. {kind}{first} "
        + ("Please report it." if debug else "Run it again with --debug for all of it, to report it."),
        file=sys.stderr,
    )
    return Exit.OUR_FAULT
