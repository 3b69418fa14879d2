"""``gam run``: from a recording to the findings of every channel and a table of health indicators.

This module owns the command and where its results go.
"""

import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib.metadata import entry_points
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from gam_db.cli import options, report
from gam_db.cli.figures import figures
from gam_db.cli.progress import Progress, interruptible
from gam_db.config import Settings
from gam_db.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError
from gam_db.findings import findings, need_attention
from gam_db.guess import guess
from gam_db.source import FILE_ENDINGS, is_file
from gam_db.study import Study

NEEDS_ATTENTION = 2

#: The estimator that is the method itself; others come by the entry points ``gam_db.estimators``.
DSE = "dse"

_OUTPUT = "Output"
_PARQUET_ENDINGS = (".parquet", ".pq")

Every = Literal["vector", "stride"]


def run(
    source: options.SourceArgument = None,
    database: options.DatabaseOption = None,
    config: options.ConfigOption = None,
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
    everything: Annotated[
        bool,
        typer.Option(
            "--all",
            help=f"Print every channel, not only the {report.SHOWN} most urgent.",
            rich_help_panel=_OUTPUT,
        ),
    ] = False,
    as_json: Annotated[
        bool,
        typer.Option("--json", help="Print one JSON object instead.", rich_help_panel=_OUTPUT),
    ] = False,
    quiet: Annotated[
        bool,
        typer.Option("--quiet", "-q", help="Print nothing but errors.", rich_help_panel=_OUTPUT),
    ] = False,
    threads: options.ThreadsOption = None,
    asset: options.AssetOption = None,
    no_asset: options.NoAssetOption = False,
    channel: options.ChannelOption = None,
    no_channel: options.NoChannelOption = False,
    time: options.TimeOption = None,
    value: options.ValueOption = None,
    wide: options.WideOption = False,
    where: options.WhereOption = None,
    m: options.MOption = None,
    tau: options.TauOption = None,
    bins: options.BinsOption = None,
    window: options.WindowOption = None,
    stride: options.StrideOption = None,
    max_gap: options.MaxGapOption = None,
    target_floor: options.TargetFloorOption = None,
    estimator: options.EstimatorOption = DSE,
    calibration_fraction: options.FractionOption = None,
    calibration_duration: options.DurationOption = None,
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
    score_from: options.ScoreFromOption = None,
    pool: options.PoolOption = None,
) -> None:
    """Compute the health indicator of every channel of SOURCE, print what was found, write the table.

    A channel needs attention (exit code 2) if its indicator is above its limit, the largest of twice
    the floor, the highest block of calibration and --target-floor, or if its calibration is not good
    enough to be watched (too_fine, needs_data). Constant channels and channels without calibration
    never raise an alarm; exit code 2 also says that no channel at all has a calibration. By another
    --estimator there is an indicator (written to SOURCE.NAME.parquet) but no verdict.
    """
    settings = options.settings(
        file=config,
        relation=source,
        database=database,
        asset=asset,
        no_asset=no_asset,
        channel=channel,
        no_channel=no_channel,
        time=time,
        value=value,
        wide=wide,
        where=where,
        m=m,
        tau=tau,
        bins=bins,
        window=window,
        stride=stride,
        max_gap=max_gap,
        target_floor=target_floor,
        calibration_fraction=calibration_fraction,
        calibration_duration=calibration_duration,
        calibrate=calibrate,
        exclude=exclude,
        score_from=score_from,
        pool=pool,
    )
    others = None if estimator.lower() == DSE else _others(estimator)
    estimator = DSE if others is None else others.estimator_named(estimator).name
    relation = options.named_relation(settings)
    results = [] if no_out else _results(relation, settings.source.database, out, every, estimator)
    with interruptible(), connect(settings.source.database, threads, writable=False) as session:
        lines = report.console()
        with Progress(session, quiet) as progress:
            job, study = open_job(session, relation, relation, settings, progress.on_step)
            if others is None:
                found = findings(study)
                code = NEEDS_ATTENTION if need_attention(found) else 0
                show = partial(report.show, lines, job, found, everything)
                told = partial(figures, job, found, code=code)
            else:
                others.add_estimator(study, estimator)
                last = study.table("last_scores").to_pylist()
                code = 0
                show = partial(others.show_scores, lines, job, estimator, last, everything)
                told = partial(others.score_figures, job, estimator, last)
        if not (as_json or quiet):
            show()
        with Progress(session, quiet) as progress:
            for result in results:
                progress.on_step(f"writing {result}")
                study.write(result.step, result.path, result.table)
        if as_json:
            written = [str(result) for result in results]
            print(json.dumps(told(written), ensure_ascii=False, indent=1))
        elif not quiet:
            for result in results:
                lines.print(f"written: {result}", soft_wrap=True)
    if code:
        raise typer.Exit(code)


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
    name: str,
    relation: Any,
    settings: Settings,
    on_step: Callable[[str], None],
) -> tuple[report.Job, Study]:
    """Return what is to be done and the study that does it.

    Args:
        session: an open session.
        name: of the source, for the report.
        relation: a table name, a file or an Arrow table.
        settings: what was said of columns, parameters and calibration.
        on_step: called with the name of each step before it is run.

    Raises:
        UserError: the source, a parameter or the calibration cannot be used.
    """
    parameters, calibration = settings.method()
    columns = session.describe(session.relation(relation))
    guessed = guess(relation, columns, settings.source, session)
    study = Study(session, guessed.source, parameters, calibration, on_step=on_step, short_cuts=True)
    file = None if settings.file is None else str(settings.file)
    return report.Job(name, guessed, parameters, calibration, file), study


@dataclass(frozen=True)
class _Result:
    """Where the rows of one step go."""

    step: str
    path: Path
    table: str

    def __str__(self) -> str:
        return f"{self.path} (table {self.table})" if _is_database(self.path) else str(self.path)


def _results(
    relation: str, database: str | None, out: Path | None, every: Every, estimator: str
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
    read = {Path(read).resolve() for read in (relation, database) if read is not None}
    for one in paths:
        if one.resolve() in read:
            raise ConfigurationError(f"{one} would be overwritten while it is read; give another --out.")
    return [
        _Result(step, one, f"gam_{table}")
        for (step, table), one in zip(steps.items(), paths[: len(steps)], strict=True)
    ]


def _stem(relation: str) -> str:
    """Return a file name for the results of a source, whatever the source is called."""
    name = Path(relation).name if is_file(relation) else relation
    for ending in sorted(FILE_ENDINGS, key=len, reverse=True):
        if name.lower().endswith(ending):
            name = name[: -len(ending)]
            break
    return re.sub(r"[^\w.-]+", "_", name).strip("._")[:100] or "gam"


def _is_database(path: Path) -> bool:
    return path.suffix in options.DATABASE_ENDINGS
