"""``gam demo``: the page of a simulated machine, or of a simulated plant."""

import shlex
from pathlib import Path

from pyarrow import parquet

from gam_db import langevin
from gam_db.alarms import Alarms
from gam_db.cli.config import Settings
from gam_db.cli.job import job_of
from gam_db.cli.options import option
from gam_db.cli.progress import working
from gam_db.cli.render import WORDS, Section, Verbatim, write
from gam_db.cli.report import checked, page_of, written
from gam_db.cli.summary import Summary
from gam_db.engines.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.findings import findings
from gam_db.reading.guess import SourceSettings
from gam_db.report import Wishes, plant
from gam_db.settings.source import Source

_SIMULATED = Settings(
    SourceSettings(asset="asset", channel="channel", time="time", value="value"),
    {"m": langevin.M, "tau": langevin.TAU, "bins": langevin.BINS, "window": langevin.WINDOW},
    {"fraction": langevin.CALIBRATION},
)


def demo(keep: Path | None = option("demo.keep"), report: Path | None = option("demo.report")) -> None:
    """Run gam on a simulated machine that wears out.

    It writes nothing, unless you add --out (the series) or --report (the page of a simulated plant).
    """
    if report is not None:
        if keep is not None:
            raise ConfigurationError("--report and --out are of different machines; leave one out.")
        path = checked(report, "--report")
        with working(connect()) as on_step:
            on_step("simulating a plant")
            wishes = Wishes(title="A simulated plant", time_zone=plant.TIME_ZONE, made=plant.END)
            method = (plant.PARAMETERS, plant.CALIBRATION, Alarms())
            figures = page_of(Source(plant.telemetry()), method, path, wishes, on_step)
        write([*written(figures), "Open it in a browser; it needs no network."])
        return
    if keep is not None and (keep.suffix != ".parquet" or not keep.parent.is_dir()):
        raise ConfigurationError(f"--out is {keep}; give a name in .parquet, in a folder that is there.")
    if keep is not None and keep.exists():
        raise ConfigurationError(f"{keep} is there already; give --out a new name, or remove it.")
    session = connect()
    with working(session) as on_step:
        on_step("simulating")
        series = langevin.series()
        job = job_of(session, _SIMULATED, series, "simulated machine")
        channels = findings(job.study(session, on_step))
    texts = WORDS["demo"]
    write([texts["introduction"], "", *Summary(job, channels).sections()])
    sections: list[Section] = [""]
    if keep is not None:
        parquet.write_table(series, keep)
        words = [f"--{name} {value}" for name, value in _SIMULATED.parameters.items()]
        words.append(f"--calibration-fraction {langevin.CALIBRATION}")
        again = f"    gam run {shlex.quote(str(keep))} {' '.join(words)}"
        sections += [f"The series is in {keep}. To compute and write its indicator:", Verbatim(again)]
    write([*sections, texts["next"], Verbatim("    gam run recording.parquet"), texts["calibration"]])
