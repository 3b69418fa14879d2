"""The command line: ``gam``. Commands are thin: parse, call, print.

This module owns the list of commands, how errors are told, and the exit codes:

* 0: done, and nothing needs attention,
* 1: something the user can mend; one paragraph on stderr says what,
* 2: done, and a channel needs attention (see :mod:`gam_db.findings`),
* 3: our fault,
* 130: interrupted.
"""

import sys
import traceback
from collections.abc import Sequence
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

import gam_db
from gam_db.cli.benchmark_stored import benchmarks
from gam_db.cli.calibrate import calibrate
from gam_db.cli.check import check
from gam_db.cli.compile import compile_script
from gam_db.cli.demo import demo
from gam_db.cli.drop import drop
from gam_db.cli.engines import engines
from gam_db.cli.evaluate import evaluate
from gam_db.cli.export import export
from gam_db.cli.init import init
from gam_db.cli.migrate import migrate
from gam_db.cli.prune import compact, prune
from gam_db.cli.reproduce import reproduce
from gam_db.cli.run import run
from gam_db.cli.score import score
from gam_db.cli.select import select
from gam_db.cli.simulate import simulate
from gam_db.cli.status import status
from gam_db.errors import StatementError, UserError

FINE, USER_ERROR, OUR_FAULT, INTERRUPTED = 0, 1, 3, 130

#: What Typer raises for options it cannot parse; it does not export the name.
_UsageError: type[Exception] = typer.BadParameter.__bases__[0]


class Commands(TyperGroup):
    """The commands, with our exit codes, and with ``--debug`` wherever it stands."""

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
    epilog="Exit codes: 0 fine, 1 something for you to mend, 2 a channel needs attention, 3 our fault.",
)


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"gam-db {gam_db.__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool, typer.Option("--version", help="Print the version.", callback=_version, is_eager=True)
    ] = False,
    debug: Annotated[
        bool, typer.Option("--debug", help="With any command: show the traceback of an error.")
    ] = False,
) -> None:
    """Take the options of every command; ``--debug`` was taken by :class:`Commands`."""


app.command()(run)
app.command()(select)
app.command()(check)
app.command()(init)
app.command()(demo)
app.command("compile")(compile_script)
app.command()(evaluate)
app.command()(calibrate)
app.command()(score)
app.command()(engines)
app.add_typer(benchmarks, name="benchmark")
app.command()(migrate)
app.command()(drop)
app.command()(status)
app.command()(prune)
app.command()(compact)
app.add_typer(export, name="export")
app.add_typer(simulate, name="simulate")
app.add_typer(reproduce, name="reproduce")


def main() -> None:
    """Run the command line."""
    app()


def _told(error: Exception, debug: bool) -> int:
    """Tell an error on stderr and return the exit code it means."""
    if isinstance(error, typer.Abort):
        return INTERRUPTED
    if debug:
        traceback.print_exception(error)
        if isinstance(error, StatementError) and error.statement:
            print(f"\nThe statement was:\n{error.statement}\n", file=sys.stderr)
    if isinstance(error, _UsageError):
        error.show()  # type: ignore[attr-defined]
        return USER_ERROR
    if isinstance(error, UserError):
        print(f"gam: {error}", file=sys.stderr)
        return USER_ERROR
    kind = "" if type(error).__module__.startswith("gam_db") else f"{type(error).__name__}: "
    print(
        f"gam: this is a fault of gam-db, not yours. {kind}{str(error).partition(chr(10))[0]} "
        + ("Please report it." if debug else "Run it again with --debug for all of it, to report it."),
        file=sys.stderr,
    )
    return OUR_FAULT
