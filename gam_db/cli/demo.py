"""``gam demo``: the whole way on a simulated machine, in seconds and without any data.

This module owns the command and its words.
"""

import shlex
from pathlib import Path
from typing import Annotated

import typer
from pyarrow import parquet

from gam_db import langevin
from gam_db.cli import report
from gam_db.cli.progress import Progress, interruptible
from gam_db.cli.run import open_job
from gam_db.config import Settings, SourceSettings
from gam_db.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.findings import findings

COLUMNS = SourceSettings(asset="asset", channel="channel", time="time", value="value")
PARAMETERS = {
    "m": langevin.M,
    "tau": langevin.TAU,
    "bins": langevin.BINS,
    "window": langevin.WINDOW,
}
CALIBRATION = {"fraction": langevin.CALIBRATION}

_INTRODUCTION = (
    "A simulated machine: a controller moves it through five positions; after 40 % of the time two of "
    "them begin to wear away, and the controller compensates. (The system is the paper's; its numbers "
    "were chosen with the paper's row for this method in view, so this is an illustration, and no "
    "evidence for that row.)"
)
_NEXT = (
    "Next, on your own data: a Parquet or CSV file, or a table of a DuckDB file, with a column each for "
    "the machine, the signal, the time and the reading (or one column per signal):"
)
_RUN = "gam run recording.parquet"
_CALIBRATION = (
    "Say when the machine was healthy by --calibration-duration '30 d' or --calibrate FROM/TO; all else "
    "is in gam run --help."
)


def demo(
    keep: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "--keep",
            metavar="FILE",
            help="Save the series as Parquet, to go on with; a file that is there is left as it is.",
        ),
    ] = None,
) -> None:
    """Simulate a machine that wears out, and print what `gam run` prints of it. Writes nothing.

    With --out it writes the series, and nothing else.
    """
    if keep is not None and (keep.suffix != ".parquet" or not keep.parent.is_dir()):
        raise ConfigurationError(f"--out is {keep}; give a name in .parquet, in a folder that is there.")
    if keep is not None and keep.exists():
        raise ConfigurationError(f"{keep} is there already; give --out a new name, or remove it.")
    lines = report.console()
    with interruptible(), connect() as session, Progress(session) as progress:
        progress.on_step("simulating")
        series = langevin.series()
        settings = Settings(COLUMNS, PARAMETERS, CALIBRATION)
        job, study = open_job(session, "simulated machine", series, settings, progress.on_step)
        found = findings(study)
    report.say(lines, _INTRODUCTION)
    lines.print()
    report.show(lines, job, found)
    lines.print()
    if keep is not None:
        parquet.write_table(series, keep)
        report.say(lines, f"The series is in {keep}. The same again, and the indicator written:")
        lines.print(f"    gam run {shlex.quote(str(keep))} {_options()}", soft_wrap=True)
    report.say(lines, _NEXT)
    lines.print(f"    {_RUN}")
    report.say(lines, _CALIBRATION)


def _options() -> str:
    """Return the demo's method as options of gam run."""
    said = [f"--{name} {value}" for name, value in PARAMETERS.items()]
    return " ".join([*said, f"--calibration-fraction {CALIBRATION['fraction']}"])
