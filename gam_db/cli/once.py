"""``gam run`` and ``gam demo``: from a recording to the findings of every channel, nothing kept.

This module owns the commands, their page, and where results go.
"""

import datetime as dt
import os
import re
import shlex
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.metadata import entry_points
from itertools import takewhile
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from pyarrow import ArrowInvalid, parquet
from rich.console import Console

from gam_db import langevin
from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.job import Job, job_of
from gam_db.cli.progress import Progress, interruptible, working
from gam_db.cli.report import checked, page_of, told
from gam_db.clock import SINCE_1970, epoch_unit, zone
from gam_db.config import Settings
from gam_db.connecting import connect
from gam_db.engines.duckdb_files import SOURCE_MARK
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, printable
from gam_db.findings import Row, findings, need_attention
from gam_db.guess import SourceSettings
from gam_db.report import Wishes, plant
from gam_db.source import FILE_ENDINGS, Source, is_file, paths_of
from gam_db.study import Study

#: The estimator that is the method itself; others come by the entry points ``gam_db.estimators``.
DSE = "dse"

_OUTPUT = "Output"
_PARQUET_ENDINGS = (".parquet", ".pq")

Every = Literal["vector", "stride"]


@options.taking(*options.READ)
def run(
    settings: Settings,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="PATH",
            help="Where the health indicator goes, replacing what is there. NAME.parquet: beside it go "
            "NAME.support.parquet and NAME.certificate.parquet. A .duckdb or .db file: tables "
            "gam_health_indicator, gam_support and gam_certificate. Default: SOURCE.health.parquet, "
            "SOURCE.support.parquet, SOURCE.certificate.parquet in the current folder.",
            rich_help_panel=_OUTPUT,
        ),
    ] = None,
    no_out: Annotated[
        bool, typer.Option("--no-out", help="Write no file.", rich_help_panel=_OUTPUT)
    ] = False,
    every: Annotated[
        Every,
        typer.Option(
            help="Rows to write: one per scored vector, or one per full bucket of --stride vectors "
            "(in a DuckDB file: table gam_health_at_buckets).",
            rich_help_panel=_OUTPUT,
        ),
    ] = "vector",
    report: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.html",
            help="Write the page for people who look, too; see gam report. Of a file, not of a table.",
            rich_help_panel=_OUTPUT,
        ),
    ] = None,
    everything: options.All = False,
    time_zone: options.TimeZone = "UTC",
    as_json: options.Json = False,
    quiet: options.Quiet = False,
    threads: options.Threads = None,
    estimator: Annotated[
        str,
        typer.Option(
            metavar="NAME",
            help="What scores vectors: dse (the method itself), or centroid, gmm, forest, ocsvm, which "
            "have no certificate and no limit. The last three need pip install "
            '"gam-db[benchmark]".',
            rich_help_panel="Parameters of the method",
        ),
    ] = DSE,
) -> None:
    """Compute the health indicator of every channel of SOURCE, print what was found, write the table.

    A channel needs attention (exit code 2) if its indicator is above its limit, the largest of twice
    the floor, the highest block of calibration and --target-floor, or if its calibration is not good
    enough to be watched (too_fine, needs_data). Constant channels and channels without calibration
    never raise an alarm; exit code 2 also says that no channel at all has a calibration. By another
    --estimator there is an indicator (written to SOURCE.NAME.parquet) but no verdict.
    """
    shown_in = zone(time_zone)
    others = None if estimator.lower() == DSE else _others(estimator)
    estimator = DSE if others is None else others.estimator_named(estimator).name
    relation = options.named_relation(settings)
    if report is not None:
        _check_report(report, relation, estimator)
    results = [] if no_out else _results(relation, settings.source.database, out, every, estimator)
    show: Callable[[Console], None]
    files = [result.path for result in results]
    with interruptible(), connect(settings.source.database, threads, False, files) as session:
        with Progress(session, quiet) as progress:
            job, study = open_job(session, relation, settings, progress.on_step)
            if others is None:
                found = findings(study)
                code = Exit.ATTENTION if need_attention(found) else Exit.FINE
                told = _figures(found)
                show = partial(_show, job=job, found=found, everything=everything, shown_in=shown_in)
            else:
                others.add_estimator(study, estimator)
                rows, code = study.rows("last_scores"), Exit.FINE
                told = {"estimator": estimator, "channels": rows}
                asked = {"estimator": estimator, "rows": rows, "everything": everything}
                show = partial(others.show_scores, job=job, **asked)
        page.tell(Exit.FINE, {}, show, quiet=as_json or quiet)
        with Progress(session, quiet) as progress:
            for result in results:
                progress.on_step(f"writing {result}")
                study.write(result.step, result.path, result.table)
            if report is not None:
                wishes = Wishes(title=Path(job.name).name)
                method = (job.parameters, job.calibration)
                page_of(job.guess.source, *method, report, wishes, progress.on_step)
    page.tell(
        code,
        {**job.figures(), **told, "written": [str(one) for one in (*results, *_pages(report))]},
        lambda lines: _written(lines, results, report),
        as_json,
        quiet,
    )


def _pages(report: Path | None) -> list[Path]:
    return [] if report is None else [report]


def _check_report(report: Path, relation: Any, estimator: str) -> None:
    checked(report, "--report")
    if not is_file(relation):
        raise ConfigurationError(
            "--report is of a file; of a table, gam calibrate, gam score and gam report make the page."
        )
    if estimator != DSE:
        raise ConfigurationError(f"--report is of {DSE}, which alone has a certificate; leave one out.")


def _others(estimator: str) -> Any:
    """Return the module of the other estimators.

    Raises:
        ConfigurationError: they are not installed.
        ParameterError: there is none of that name.
    """
    try:
        others = next(found.load() for found in entry_points(group="gam_db.estimators"))
    except (StopIteration, ModuleNotFoundError) as error:
        raise ConfigurationError(
            f"--estimator is {estimator}; all but {DSE} are part of the laboratory, which is not "
            "installed here."
        ) from error
    others.estimator_named(estimator)
    return others


def open_job(
    session: Session,
    relation: Any,
    settings: Settings,
    on_step: Callable[[str], None],
    name: str | None = None,
) -> tuple[Job, Study]:
    """Return what is to be done and the study that does it; see :func:`job_of`."""
    job = job_of(session, settings, relation, name)
    asked = (job.guess.source, job.parameters, job.calibration)
    return job, Study(session, *asked, on_step=on_step, short_cuts=True)


def _figures(found: Sequence[Row]) -> dict[str, Any]:
    return {
        "channels": [{**row, "course": page.thinned(row["course"])} for row in found],
        "verdicts": Counter(row["verdict"] for row in found),
        "needs_attention": need_attention(found),
    }


def _show(
    out: Console,
    job: Job,
    found: Sequence[Row],
    everything: bool = False,
    shown_in: dt.tzinfo = dt.UTC,
) -> None:
    assets, samples = {row["asset"] for row in found}, sum(row["samples"] for row in found)
    page.say(
        out,
        f"{printable(job.name)}: {number_of(len(found), 'channel')} of "
        f"{number_of(len(assets), 'asset')}, {samples:,} samples{job.settings}",
    )
    for line in job.lines():
        page.say(out, line)
    out.print()
    shown = found if everything else found[: options.SHOWN]
    page.channels(out, shown, "last_time", "all that is scored", shown_in, everything)
    page.cut(out, found, everything, page.counted(found[len(shown) :]))
    out.print()
    page.say(out, f"verdicts: {page.verdicts(found)}")
    page.say(out, f"channels: {page.counted(found)}; judged by the health indicator and its limit")
    if job.parameters.is_open:
        taken = sorted(Counter(row["bins"] for row in found).items(), reverse=True)
        page.say(out, f"bins taken: {', '.join(f'{bins} for {count:,}' for bins, count in taken)}")
    for line in page.advice(found):
        page.say(out, line)
    ends = [row["last_time"] for row in found if isinstance(row["last_time"], int)]
    unit = epoch_unit(min(ends), max(ends)) if ends else None
    if unit is not None:
        page.say(
            out,
            f"time looks like {SINCE_1970[unit][0]} since 1970, and is taken as a counter; --time-unit "
            f"{unit} makes calendar time of it",
        )
    short = [
        row
        for row in found
        if row["hi_limit"] is not None and 0 < row["calibration_vectors"] < 8 * row["window"]
    ]
    if short:
        page.say(
            out,
            f"{len(short)} ready, but on a calibration shorter than 8 windows: their floors come from "
            "blocks shorter than a window",
        )
    if not need_attention(found):
        page.say(out, "nothing needs attention")
    page.say(out, page.legend(found, everything))


@dataclass(frozen=True)
class _Result:
    """Where the rows of one step go."""

    step: str
    path: Path
    table: str

    def __str__(self) -> str:
        return f"{self.path} (table {self.table})" if _is_database(self.path) else str(self.path)


def _written(out: Console, results: Sequence[_Result], report: Path | None) -> None:
    for result in (*results, *_pages(report)):
        out.print(f"written: {printable(str(result))}", soft_wrap=True)


def _results(
    relation: Any, database: str | None, out: Path | None, every: Every, estimator: str
) -> list[_Result]:
    """Return what is written where; refuse, before any work, what cannot be written."""
    health = ("bucket_health", "health_at_buckets") if every == "stride" else ("health_indicator",) * 2
    steps = {health[0]: health[1], "support_summary": "support", "certificate": "certificate"}
    if estimator != DSE:
        steps = {
            f"score_{health[0]}" if every == "stride" else "score_health": f"{health[1]}_{estimator}"
        }
    ending = "health" if estimator == DSE else estimator
    path = Path(f"{_stem(relation)}.{ending}.parquet") if out is None else out
    if _is_database(path):
        paths = [path] * 3
    elif path.suffix.lower() in _PARQUET_ENDINGS:
        name = path.stem.removesuffix(".health")
        beside = [path.with_name(f"{name}.{what}{path.suffix}") for what in ("support", "certificate")]
        paths = [path, *beside]
    else:
        raise ConfigurationError(
            f"--out is {path}; give a Parquet file (.parquet) or a DuckDB file (.duckdb, .db)."
        )
    if not path.parent.is_dir():
        raise ConfigurationError(f"--out is {path}; the folder {path.parent} is not there.")
    for one in paths:
        if not os.access(one if one.exists() else one.parent, os.W_OK):
            raise ConfigurationError(f"--out is {path}; you may not write {one}.")
    if out is None and not _is_database(path):
        _check_theirs(path, relation)
    read = {Path(one).resolve() for one in (*paths_of(relation), database) if one is not None}
    for one in paths:
        if one.resolve() in read and not (isinstance(relation, tuple) and _made_from(one)):
            raise ConfigurationError(f"{one} would be overwritten while it is read; give another --out.")
    return [
        _Result(step, one, f"gam_{table}")
        for (step, table), one in zip(steps.items(), paths[: len(steps)], strict=True)
    ]


def _check_theirs(path: Path, relation: Any) -> None:
    """Refuse to write over the results of another source that is called alike.

    Results may be replaced where all that they were made from is read again.

    Raises:
        ConfigurationError: the file holds such.
    """
    of = _made_from(path)
    read = [Path(os.path.abspath(one)) for one in paths_of(relation)]
    read = [one.parent if "*" in one.name else one for one in read]
    if (
        of
        and is_file(relation)
        and not all(any(map(Path(one).is_relative_to, read)) for one in of.split(";"))
    ):
        raise ConfigurationError(
            f"{path} holds the results of {of}, a source of the same name; say --out, or remove it."
        )


def _made_from(path: Path) -> str:
    """Return what a file of results was made from; empty where there is none, or it is none of ours."""
    try:
        said = parquet.read_metadata(path).metadata or {}
    except (OSError, ArrowInvalid):
        return ""
    return str(said.get(SOURCE_MARK.encode(), b"").decode())


def _stem(relation: Any) -> str:
    """Return a file name for the results of a source, whatever the source is called.

    Of several files it is what their names begin with, as it is that of a pattern: then results among
    them, where a shell wrote a pattern out, change nothing.
    """
    name = relation
    if is_file(relation):
        signs = zip(*(Path(one).name for one in paths_of(relation)), strict=False)
        name = "".join(first for first, *others in takewhile(lambda at: len({*at}) == 1, signs))
    for ending in sorted(FILE_ENDINGS, key=len, reverse=True):
        if name.lower().endswith(ending):
            name = name[: -len(ending)]
            break
    return re.sub(r"[^\w.-]+", "_", name).strip("._")[:100] or "gam"


def _is_database(path: Path) -> bool:
    return path.suffix in options.DATABASE_ENDINGS


_SIMULATED = Settings(
    SourceSettings(asset="asset", channel="channel", time="time", value="value"),
    {"m": langevin.M, "tau": langevin.TAU, "bins": langevin.BINS, "window": langevin.WINDOW},
    {"fraction": langevin.CALIBRATION},
)
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
_CALIBRATION = (
    "Say when the machine was healthy by --calibration-duration '30 d' or --calibrate FROM/TO; all else "
    "is in gam run --help."
)


def _report_plant(path: Path) -> None:
    """Write the page of the simulated plant."""
    session = connect()
    with session, working(session) as on_step:
        on_step("simulating a plant")
        wishes = Wishes(title="A simulated plant", time_zone=plant.TIME_ZONE, made=plant.END)
        asked = (Source(plant.telemetry()), plant.PARAMETERS, plant.CALIBRATION, path, wishes)
        figures = page_of(*asked, on_step)
    told(page.console(), figures)
    page.say(page.console(), "Open it in a browser; it needs no network.")


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
    report: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE.html",
            help="Write instead the page of a small simulated plant, with every kind of change.",
        ),
    ] = None,
) -> None:
    """Simulate a machine that wears out, and print what `gam run` prints of it. Writes nothing.

    With --out it writes the series, with --report the page of a simulated plant, and nothing else.
    """
    if report is not None:
        if keep is not None:
            raise ConfigurationError("--report and --out are of different machines; leave one out.")
        _report_plant(checked(report, "--report"))
        return
    if keep is not None and (keep.suffix != ".parquet" or not keep.parent.is_dir()):
        raise ConfigurationError(f"--out is {keep}; give a name in .parquet, in a folder that is there.")
    if keep is not None and keep.exists():
        raise ConfigurationError(f"{keep} is there already; give --out a new name, or remove it.")
    session = connect()
    with working(session) as on_step:
        on_step("simulating")
        series = langevin.series()
        job, study = open_job(session, series, _SIMULATED, on_step, "simulated machine")
        found = findings(study)
    lines = page.console()
    page.say(lines, _INTRODUCTION)
    lines.print()
    _show(lines, job, found)
    lines.print()
    if keep is not None:
        parquet.write_table(series, keep)
        words = [f"--{name} {value}" for name, value in _SIMULATED.parameters.items()]
        words.append(f"--calibration-fraction {langevin.CALIBRATION}")
        page.say(lines, f"The series is in {keep}. The same again, and the indicator written:")
        lines.print(f"    gam run {shlex.quote(str(keep))} {' '.join(words)}", soft_wrap=True)
    page.say(lines, _NEXT)
    lines.print("    gam run recording.parquet")
    page.say(lines, _CALIBRATION)
