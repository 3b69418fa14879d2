"""``gam run``: from a recording to the findings of every channel, nothing kept."""

import datetime as dt
import os
import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from importlib.metadata import entry_points
from itertools import takewhile
from pathlib import Path
from typing import Any, Literal

import pyarrow.compute as pc
from pyarrow import ArrowInvalid, parquet

from gam_db.address import is_url
from gam_db.checking.notes import EXACT_UP_TO, SENTENCES
from gam_db.checking.words import number_of
from gam_db.cli import automatic, options, page
from gam_db.cli import machines as of_machines
from gam_db.cli import programs as of_programs
from gam_db.cli.config import Settings
from gam_db.cli.job import Job, job_of
from gam_db.cli.options import option
from gam_db.cli.progress import Progress, interruptible
from gam_db.cli.report import checked, page_of
from gam_db.clock import SINCE_1970, epoch_unit, shown_instant, zone
from gam_db.engines.connecting import connect
from gam_db.engines.duckdb.files import SOURCE_MARK
from gam_db.errors import ConfigurationError, printable, wrong
from gam_db.findings import Row, findings, is_blind, lack_data, need_attention
from gam_db.reading.ahead import ahead_sentences
from gam_db.report import Wishes
from gam_db.settings.source import FILE_ENDINGS, is_file, paths_of
from gam_db.stored.lengths import park_after
from gam_db.study import Study
from gam_db.study.automatic import Siblings

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
    """Compute the health indicator of every channel of SOURCE, print what was found, write the table.

    A channel needs attention (exit code 2) if an episode of it does, one that is open or began right
    after calibration; or, where calibration gave no limit of judgements, if its indicator is above its
    limit, the largest of twice the floor, the highest block of calibration and --target-floor; or if its
    calibration is not good enough to be watched (too_fine, needs_data, or no fair sample of what
    followed); or if it would show no shift of its machine (blind). Constant channels and channels
    without calibration never raise an alarm; where no channel needs attention, exit code 4 says that one
    has no usable reading in calibration, that none can be judged, or that a program was calibrated too
    little or never. By another --estimator there is an
    indicator (written to SOURCE.NAME.parquet) but no verdict.
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
    written = [str(one) for one in (*results, *([] if report is None else [report]))]
    shows: Callable[[page.Out], None]
    files, everything = [result.path for result in results], common.everything
    is_own = any(_is_same(one, settings.source.database) for one in files)
    opened = connect(settings.source.database, common.threads, is_own, files)
    with interruptible(), opened as session:
        with Progress(session, common.quiet) as progress:
            job = job_of(session, settings, relation)
            study = job.study(session, progress.on_step, short_cuts=others is None)
            if others is None:
                longest = park_after(settings.monitor.park_after, study.method.kind)
                found = findings(study, settings.alarms, longest)
                names = {"signals": "channels", "since_tick": "since"}
                ranked = study.table("ranked_machines").sort_by("machine_rank").to_pylist()
                machines = [{names.get(of, of): one for of, one in row.items()} for row in ranked]
                ended = study.table("episodes").filter(pc.field("is_open") == 0).to_pylist()
                urgent = need_attention(found) or any(map(is_blind, found))
                programs: list[Row] = []
                if study.method.programs is not None:  # by way of Arrow: instants may have a zone
                    programs = study.table("program_summary").to_pylist()
                lacking = lack_data(found) or bool(of_programs.unjudged(programs))
                told = {
                    "channels": [{**row, "course": page.thinned(row["course"])} for row in found],
                    "machines": machines,
                    "ended_episodes": ended,
                    "verdicts": Counter(row["verdict"] for row in found),
                    "chosen": automatic.figures(study.siblings),
                    "judged_by_episode": sum(row["judged_by"] == "episode" for row in found),
                    "needs_attention": urgent,
                    **({} if study.method.programs is None else {"programs": programs}),
                }
                more = partial(show, everything=everything, siblings=study.siblings, programs=programs)
                more = partial(more, machines=machines, ended=ended)
                shows = partial(more, job=job, found=found, shown_in=shown_in)
            else:
                others.add_estimator(study, estimator)
                rows, urgent, lacking = study.rows("last_scores"), False, False
                told = {"estimator": estimator, "channels": rows}
                asked = {"estimator": estimator, "rows": rows, "everything": everything}
                shows = partial(others.show_scores, job=job, **asked)
        if not (common.as_json or common.quiet):
            shows(page.console())
            page.say(page.console(), *ahead_sentences(study.ahead, len(told["channels"]), study.clock))
        told["ahead"] = ahead_of(study)
        lacking = lacking or bool(study.ahead)
        with Progress(session, common.quiet) as progress:
            for result in results:
                progress.on_step(f"writing {result}")
                study.write(result.step, result.path, result.table)
            if report is not None:
                wishes = Wishes(title=Path(job.name).name)
                method = (job.parameters, job.calibration, settings.alarms)
                page_of(job.guess.source, method, report, wishes, progress.on_step)

    def show_written(lines: page.Out) -> None:
        for one in written:
            lines.print(f"written: {printable(one)}", soft_wrap=True)

    page.tell(
        {**job.figures(), **told, "written": written}, show_written, common, urgent, lacking=lacking
    )


def ahead_of(study: Study) -> list[Row]:
    """Return the channels of a study with rows that are later than now, as --json prints them."""
    kind = study.method.kind
    return [{**row, "ahead_to": shown_instant(row["ahead_to"], kind)} for row in study.ahead]


def _others(estimator: str) -> Any:
    try:
        others = next(found.load() for found in entry_points(group="gam_db.estimators"))
    except (StopIteration, ModuleNotFoundError) as error:
        raise wrong("estimator_of_laboratory", estimator=estimator, own=DSE) from error
    return others


def show(
    out: page.Out,
    job: Job,
    found: Sequence[Row],
    everything: bool = False,
    shown_in: dt.tzinfo = dt.UTC,
    siblings: Sequence[Siblings] = (),
    programs: Sequence[Row] = (),
    machines: Sequence[Row] = (),
    ended: Sequence[Row] = (),
) -> None:
    """Print what was found of each channel, what calibration chose for siblings, and what it lacks."""
    samples = sum(row["samples"] for row in found)
    page.say(out, f"{printable(job.name)}: {page.amount(found)}, {samples:,} samples{job.settings}")
    page.say(out, *job.lines())
    out.print()
    shown = found if everything else found[: options.SHOWN]
    page.channels(out, shown, "last_time", "all that is scored", shown_in, everything)
    page.cut(out, found, everything, page.counted)
    out.print()
    if len(machines) > 1:
        of_machines.show(out, machines, shown_in, everything)
    page.say(out, *_ended(ended if everything else ended[: options.SHOWN], shown_in))
    page.cut(out, ended, everything, what=" episodes that ended")
    page.say(out, f"verdicts: {page.verdicts(found)}")
    judged = Counter(row["judged_by"] for row in found)
    by = [(said, judged[name]) for name, said in _JUDGED_BY if judged[name]]
    words = ", ".join(f"{said}: {count:,}" if len(by) > 1 else said for said, count in by)
    page.say(out, f"channels: {page.counted(found)}{f'; judged by {words}' if words else ''}")
    page.say(out, *of_machines.far_above(found))
    page.say(out, *page.unseen(found))
    lacking = of_programs.lines(programs)
    page.say(out, *(lacking if everything else lacking[: options.SHOWN]))
    page.cut(out, lacking, everything, what=" programs")
    if silent := sum(row["silent"] for row in found):
        page.say(out, f"silent: {silent:,}")
    if job.parameters.is_open:
        page.say(out, *automatic.lines(siblings, everything))
        taken = sorted(Counter(row["bins"] for row in found).items(), reverse=True)
        page.say(out, f"bins taken: {', '.join(f'{bins} for {count:,}' for bins, count in taken)}")
    page.say(out, *page.advice(found))
    ends = [row["last_time"] for row in found if isinstance(row["last_time"], int)]
    if ends and (unit := epoch_unit(min(ends), max(ends))):
        like = f"time looks like {SINCE_1970[unit][0]} since 1970, and is taken as a counter"
        page.say(out, f"{like}; --time-unit {unit} makes calendar time of it")
    if short := sum(
        row["hi_limit"] is not None and 0 < row["calibration_vectors"] < 8 * row["window"]
        for row in found
    ):
        page.say(out, page.WORDS["run"]["short"].format(short=short))
    value = getattr(job.guess.source, "value", None)
    if beyond := sum(
        (value or row["channel"]) in job.exact
        and max(abs(row["calibrated_lo"] or 0), abs(row["calibrated_hi"] or 0)) >= EXACT_UP_TO
        for row in found
    ):
        page.say(out, f"{number_of(beyond, 'channel')} of {SENTENCES['beyond']}")
    if not (need_attention(found) or any(map(is_blind, found)) or lack_data(found) or lacking):
        page.say(out, "nothing needs attention")
    page.say(out, page.legend(found, everything))


def _ended(rows: Sequence[Row], zone: dt.tzinfo) -> Iterator[str]:
    """Yield a line for each episode that ended."""
    name = page.name_in(rows)
    for row in rows:
        first, last = (page.time_text(row[of], zone) for of in ("onset_time", "last_time"))
        proving = ", right after calibration" if row["is_proving"] else ""
        yield f"episode that ended: {name(row)}, from {first} to {last}{proving}"


#: Values of judged_by, and what they mean.
_JUDGED_BY = (("episode", "episodes"), ("indicator", "the health indicator and its limit"))


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
    for one in paths:
        if not os.access(one if one.exists() else one.parent, os.W_OK):
            raise ConfigurationError(f"--out is {path}; you may not write {one}.")
    if out is None and not _is_database(path):
        _check_theirs(path, relation)
    results = [
        Result(step, one, f"gam_{table}")
        for (step, table), one in zip(steps.items(), paths[: len(steps)], strict=True)
    ]
    if _is_same(path, database) and _is_database(path):
        # Tables are made beside those that are read.
        if str(relation).casefold().rpartition(".")[2] in {one.table for one in results}:
            raise ConfigurationError(
                f"{relation} would be overwritten while it is read; give another --out."
            )
        return results
    read = {Path(one).resolve() for one in (*paths_of(relation), database) if one is not None}
    for one in paths:
        if one.resolve() in read and not (isinstance(relation, tuple) and _made_from(one)):
            raise ConfigurationError(f"{one} would be overwritten while it is read; give another --out.")
    return results


def _is_same(path: Path, database: str | None) -> bool:
    return database is not None and not is_url(database) and path.resolve() == Path(database).resolve()


def _check_theirs(path: Path, relation: Any) -> None:
    """Refuse to write over the results of another source that is called alike.

    Results may be replaced where all that they were made from is read again.
    """
    of = _made_from(path)
    read = [Path(os.path.abspath(one)) for one in paths_of(relation)]
    read = [one.parent if "*" in one.name else one for one in read]
    is_theirs = not all(any(map(Path(one).is_relative_to, read)) for one in of.split(";"))
    if of and is_file(relation) and is_theirs:
        raise wrong("results_of_another", path=path, of=of)


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
