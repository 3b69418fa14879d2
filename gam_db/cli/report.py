"""``gam report``: the page for people who look, as one HTML file.

This module owns the command, and the page of a file without a monitor; :mod:`gam_db.report` makes it.
"""

import datetime as dt
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from gam_db.calibration import Calibration
from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.progress import working
from gam_db.cli.watch import watched
from gam_db.config import Settings
from gam_db.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.parameters import Parameters
from gam_db.report import Wishes
from gam_db.running import Listener
from gam_db.source import AnySource
from gam_db.stored.monitor import Monitor

_ENDINGS = (".html", ".htm")


@options.taking(*options.STATE, source=False, state=True)
def report(
    settings: Settings,
    out: Annotated[
        Path, typer.Option("--out", metavar="FILE", help="The page, replacing what is there.")
    ] = Path("report.html"),
    signal: Annotated[
        list[str] | None,
        typer.Option(
            metavar="ASSET/CHANNEL", help="Show this signal in detail in any case; may be given again."
        ),
    ] = None,
    details: Annotated[
        int, typer.Option(min=0, help="Signals in detail, the most urgent of each machine.")
    ] = 24,
    since: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH", help="How far back the page looks, as '7 d'. Default: to calibration."
        ),
    ] = None,
    time_zone: Annotated[
        str, typer.Option(metavar="NAME", help="The plant's time zone, as Europe/Berlin.")
    ] = "UTC",
    title: Annotated[str, typer.Option(help="Stands above the page.")] = Wishes.title,
    asset: Annotated[
        str,
        typer.Option(metavar="PATTERN", help="Only these machines; * and ? stand for any text or sign."),
    ] = "*",
    no_raw: Annotated[
        bool, typer.Option("--no-raw", help="Leave raw readings out, and read no source.")
    ] = False,
    made: Annotated[
        str | None,
        typer.Option(metavar="TIME", help="When the page says it was made. Default: now.", hidden=True),
    ] = None,
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Write the page for people who look: which machines left health, since when, and where they went.

    One HTML file that needs no network and nothing else; any browser opens it. It reads the state, and
    raw readings of the signals in detail where the source can be read.
    """
    wishes = Wishes(
        title=title,
        details=details,
        signals=tuple(signal or ()),
        since=since,
        time_zone=time_zone,
        raw=not no_raw,
        asset=asset,
        made=_made(made),
    )
    path = checked(out, "--out")
    with (
        options.opened(settings, writable=False) as session,
        working(session, quiet or as_json) as on_step,
    ):
        monitor, _ = watched(session, settings, settings.source.relation)
        figures = monitor.report(path, wishes, on_step)
    page.tell(Exit.FINE, figures, lambda lines: told(lines, figures), as_json, quiet)


def checked(path: Path, option: str) -> Path:
    """Return the path of a page.

    Raises:
        ConfigurationError: it has another ending, or its folder is not there.
    """
    if path.suffix.lower() not in _ENDINGS:
        raise ConfigurationError(f"{option} is {path}; give a file in .html.")
    if not path.parent.is_dir():
        raise ConfigurationError(f"{option} is {path}; the folder {path.parent} is not there.")
    return path


def page_of(
    source: AnySource,
    parameters: Parameters,
    calibration: Calibration,
    path: Path,
    wishes: Wishes,
    on_step: Listener,
) -> dict[str, Any]:
    """Write the page of a source: calibrated and scored in memory, then forgotten.

    Raises:
        UserError: the source cannot be used, or the file cannot be written.
    """
    with connect() as session:
        monitor = Monitor(session, source, parameters, calibration)
        monitor.migrate()
        monitor.calibrate(on_step=on_step)
        monitor.score(on_step=on_step)
        return monitor.report(path, wishes, on_step)


def told(lines: Console, figures: Mapping[str, Any]) -> None:
    """Print what was written."""
    page.say(
        lines,
        f"{figures['path']}: {number_of(figures['machines'], 'machine')}, "
        f"{number_of(figures['signals'], 'signal')}, {figures['details']} in detail, "
        f"{figures['above']} above their limit, {figures['new']} of them new; "
        f"{figures['bytes'] / 1e6:.1f} MB",
    )
    if figures["raw"] is not None:
        page.say(lines, f"raw readings are not in it: {figures['raw']}")


def _made(text: str | None) -> dt.datetime | None:
    if text is None:
        return None
    try:
        found = dt.datetime.fromisoformat(text)
    except ValueError:
        raise ConfigurationError(
            f"--made is {text!r}; give a time such as 2026-03-30T05:00:00+00:00."
        ) from None
    return found if found.tzinfo is not None else found.replace(tzinfo=dt.UTC)
