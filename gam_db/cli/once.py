"""``gam run``: from a recording to the findings of every channel, nothing kept."""

import contextlib
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from importlib.metadata import entry_points
from itertools import takewhile
from pathlib import Path
from typing import Any, Literal

from pyarrow import ArrowInvalid, parquet

from gam_db.address import is_url
from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.cli.job import job_of
from gam_db.cli.options import option
from gam_db.cli.progress import Progress, interruptible
from gam_db.cli.render import Page, Section, Verbatim, show, write
from gam_db.cli.report import checked, page_of
from gam_db.cli.summary import ahead_of, summarised
from gam_db.clock import zone
from gam_db.engines.connecting import connect
from gam_db.engines.duckdb.files import SOURCE_MARK
from gam_db.errors import ConfigurationError, wrong
from gam_db.reading.ahead import ahead_sentences
from gam_db.report import Wishes
from gam_db.settings.source import FILE_ENDINGS, is_file, paths_of
from gam_db.stored.lengths import park_after

#: The estimator that is the method itself; others come by the entry points ``gam_db.estimators``.
DSE = "dse"

_PARQUET_ENDINGS = (".parquet", ".pq")

Every = Literal["vector", "stride"]


@options.taking(*options.READ, *options.ALARMS, *options.PAGE, "time_zone", "threads")
def run(
    settings: Settings,
    common: options.Common,
    out: Path | None = option("run.out"),
    no_out: bool = option("run.no_out", False),
    every: Every = option("run.every", "vector"),
    report: Path | None = option("run.report"),
    estimator: str = option("run.estimator", DSE),
) -> None:
    """Compute and write the health indicator of every channel.

    A channel needs attention (exit code 2) if one of its episodes is open or began right after
    calibration. Without a limit for judgements, it needs attention if its indicator is above its limit:
    the largest of twice the floor, the highest block of calibration and --target-floor. It also needs
    attention if its calibration is not good enough to be watched (too_fine, needs_data, or not a fair
    sample of what followed), or if it would show no shift of its machine (blind). Constant channels and
    channels without calibration never raise an alarm. If no channel needs attention, exit code 4 means
    that a channel has no usable reading in calibration, that no channel can be judged, or that a program
    was calibrated too little or never. Another --estimator gives an indicator (in SOURCE.NAME.parquet),
    but no verdict.
    """
    shown_in = zone(common.time_zone)
    others = None if estimator.lower() == DSE else _others(estimator)
    estimator = DSE if others is None else others.estimator_named(estimator).name
    relation = options.named_relation(settings)
    if report is not None:
        checked(report, "--report")
        if not is_file(relation):
            raise wrong("report_of_a_table")
        if others is not None:
            raise wrong("report_of_an_estimator", own=DSE)
    results = [] if no_out else results_of(relation, settings.source.database, out, every, estimator)
    written = [str(output) for output in (*results, *([] if report is None else [report]))]
    sections: Iterable[Section]
    files, everything = [result.path for result in results], common.everything
    is_writable = any(_is_same(path, settings.source.database) for path in files)
    opened = connect(settings.source.database, common.threads, is_writable, files)
    with interruptible(), opened as session:
        with Progress(session, common.quiet) as progress:
            job = job_of(session, settings, relation)
            study = job.study(session, progress.on_step, short_cuts=others is None)
            if others is None:
                longest = park_after(settings.monitor.park_after, study.method.kind)
                summary = summarised(study, job, settings.alarms, longest)
                urgent, lacking, figures = summary.needs_attention, summary.lacks_data, summary.figures()
                sections = summary.sections(everything, shown_in)
            else:
                others.add_estimator(study, estimator)
                rows, urgent = study.rows("last_scores"), False
                figures = {"estimator": estimator, "channels": rows}
                sections = [
                    *others.sections(job, estimator, rows, everything),
                    *ahead_sentences(study.ahead, len(rows), study.clock),
                ]
                figures["ahead"], lacking = ahead_of(study), bool(study.ahead)
        if not (common.as_json or common.quiet):
            # Who reads the page may close it early, as head does; rich then ends the process.
            with contextlib.suppress(BrokenPipeError, SystemExit):
                write(sections)
        with Progress(session, common.quiet) as progress:
            for result in results:
                progress.on_step(f"writing {result}")
                study.write(result.step, result.path, result.table)
            if report is not None:
                wishes = Wishes(title=Path(job.name).name)
                method = (job.parameters, job.calibration, settings.alarms)
                page_of(job.guess.source, method, report, wishes, progress.on_step)

    ending = (Verbatim(f"written: {output}") for output in written)
    show(Page({**job.figures(), **figures, "written": written}, ending, urgent, lacking), common)


def _others(estimator: str) -> Any:
    try:
        others = next(entry.load() for entry in entry_points(group="gam_db.estimators"))
    except (StopIteration, ModuleNotFoundError) as error:
        raise wrong("estimator_of_laboratory", estimator=estimator, own=DSE) from error
    return others


@dataclass(frozen=True)
class Result:
    """Where the rows of one step go."""

    step: str
    path: Path
    table: str

    def __str__(self) -> str:
        return f"{self.path} (table {self.table})" if _is_database(self.path) else str(self.path)


def results_of(
    relation: Any, database: str | None, out: Path | None, every: Every, estimator: str
) -> list[Result]:
    """Return what is written where; refuse, before any work, what cannot be written."""
    health = ("bucket_health", "health_at_buckets") if every == "stride" else ("health_indicator",) * 2
    # No table is called like one of the state of a monitor, which may lie in the same file.
    steps = {health[0]: health[1], **{step: step for step in ("support_summary", "certificate")}}
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
        raise wrong("out_of_another_kind", path=path)
    if not path.parent.is_dir():
        raise ConfigurationError(f"--out is {path}; the folder {path.parent} is not there.")
    for target in paths:
        if not os.access(target if target.exists() else target.parent, os.W_OK):
            raise ConfigurationError(f"--out is {path}; you may not write {target}.")
    if out is None and not _is_database(path):
        _check_theirs(path, relation)
    results = [
        Result(step, target, f"gam_{table}")
        for (step, table), target in zip(steps.items(), paths[: len(steps)], strict=True)
    ]
    if _is_same(path, database) and _is_database(path):
        # Tables are made beside those that are read.
        if str(relation).casefold().rpartition(".")[2] in {result.table for result in results}:
            raise ConfigurationError(
                f"{relation} would be overwritten while it is read; give another --out."
            )
        return results
    read = {Path(source).resolve() for source in (*paths_of(relation), database) if source is not None}
    for target in paths:
        if target.resolve() in read and not (isinstance(relation, tuple) and _sources_of(target)):
            raise ConfigurationError(
                f"{target} would be overwritten while it is read; give another --out."
            )
    return results


def _is_same(path: Path, database: str | None) -> bool:
    return database is not None and not is_url(database) and path.resolve() == Path(database).resolve()


def _check_theirs(path: Path, relation: Any) -> None:
    """Refuse to write over the results of another source that is called alike.

    Results may be replaced where all that they were made from is read again.
    """
    of = _sources_of(path)
    read = [Path(os.path.abspath(source)) for source in paths_of(relation)]
    read = [source.parent if "*" in source.name else source for source in read]
    is_theirs = not all(any(map(Path(source).is_relative_to, read)) for source in of.split(";"))
    if of and is_file(relation) and is_theirs:
        raise wrong("results_of_another", path=path, of=of)


def _sources_of(path: Path) -> str:
    """Return what a file of results was made from; empty where there is none, or it is none of ours."""
    try:
        metadata = parquet.read_metadata(path).metadata or {}
    except (OSError, ArrowInvalid):
        return ""
    return str(metadata.get(SOURCE_MARK.encode(), b"").decode())


def _stem(relation: Any) -> str:
    """Return a file name for the results of a source, whatever the source is called.

    Of several files it is what their names begin with, as it is that of a pattern: then results among
    them, where a shell wrote a pattern out, change nothing.
    """
    name = relation
    if is_file(relation):
        signs = zip(*(Path(path).name for path in paths_of(relation)), strict=False)
        name = "".join(first for first, *others in takewhile(lambda at: len({*at}) == 1, signs))
    for ending in sorted(FILE_ENDINGS, key=len, reverse=True):
        if name.lower().endswith(ending):
            name = name[: -len(ending)]
            break
    return re.sub(r"[^\w.-]+", "_", name).strip("._")[:100] or "gam"


def _is_database(path: Path) -> bool:
    return path.suffix in options.DATABASE_ENDINGS
