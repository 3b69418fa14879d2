"""``gam report``: the page for people who look, as one HTML file.

This module owns the command, and the page of a file without a monitor; :mod:`gam_db.report` makes it.
"""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from gam_db.alarms import Alarms
from gam_db.checking.words import number_of
from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.cli.job import watched
from gam_db.cli.options import option
from gam_db.cli.progress import working
from gam_db.cli.render import WORDS, Page, show
from gam_db.engines.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.report import Wishes
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource
from gam_db.stored.monitor import Monitor
from gam_db.study.running import Listener

_ENDINGS = (".html", ".htm")


@options.of_state(*options.STATE, "as_json", "quiet")
def report(
    settings: Settings,
    wishes: Wishes,
    common: options.Common,
    out: Path = option("report.out", Path("report.html")),
) -> None:
    """Write an HTML page that shows which machines left health.

    The page shows since when, and where the signals went. It is one HTML file that needs no network. gam
    reads the state, and the raw readings of the signals in detail if it can read the source.
    """
    path = checked(out, "--out")
    silent = common.quiet or common.as_json
    with options.opened(settings, writable=False) as session, working(session, silent) as on_step:
        monitor, _ = watched(session, settings, settings.source.relation)
        figures = monitor.report(path, wishes, on_step)
    show(Page(figures, written(figures)), common)


def checked(path: Path, option: str) -> Path:
    """Return the path of a page; refuse another ending, and a folder that is not there."""
    if path.suffix.lower() not in _ENDINGS:
        raise ConfigurationError(f"{option} is {path}; give a file in .html.")
    if not path.parent.is_dir():
        raise ConfigurationError(f"{option} is {path}; the folder {path.parent} is not there.")
    return path


def page_of(
    source: AnySource,
    method: tuple[Parameters, Calibration, Alarms],
    path: Path,
    wishes: Wishes,
    on_step: Listener,
) -> dict[str, Any]:
    """Write the page of a source: calibrated and scored in memory, then forgotten."""
    with connect() as session:
        # A recording ended when it did: no channel of it is silent by the clock of today.
        monitor = Monitor(session, source, *method, park_after=False)
        monitor.migrate()
        monitor.calibrate(on_step=on_step)
        monitor.score(on_step=on_step)
        return monitor.report(path, wishes, on_step)


def written(figures: Mapping[str, Any]) -> Iterator[str]:
    """Yield what was written."""
    counted = {f"all_{of}s": number_of(figures[f"{of}s"], of) for of in ("machine", "signal")}
    yield WORDS["report"]["written"].format(**figures, **counted, size=figures["bytes"] / 1e6)
    if figures["raw"] is not None:
        yield f"raw readings are not in it: {figures['raw']}"
