"""What ``gam run`` prints, called from Python, too."""

import dataclasses
import datetime as dt
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import pyarrow.compute as pc

from gam_db.alarms import Alarms
from gam_db.arguments import public
from gam_db.checking.look import exact_columns
from gam_db.checking.notes import EXACT_UP_TO, SENTENCES
from gam_db.checking.words import number_of
from gam_db.cli import automatic, options, page, pools
from gam_db.cli import machines as of_machines
from gam_db.cli import programs as of_programs
from gam_db.cli.course import thinned
from gam_db.cli.job import Job
from gam_db.cli.render import WORDS, Section, text_of, time_text
from gam_db.clock import SINCE_1970, epoch_unit, shown_instant, zone
from gam_db.engines.connecting import borrowed
from gam_db.errors import printable
from gam_db.findings import Row, findings, is_blind, lack_data, need_attention
from gam_db.reading.ahead import ahead_sentences
from gam_db.reading.guess import looked_up
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source, WideSource, is_file, shown_relation
from gam_db.stored.lengths import park_after
from gam_db.study import Study
from gam_db.study.automatic import Siblings

#: What columns of a machine are called in results.
_MACHINE = {"signals": "channels", "since_tick": "since"}

#: Values of judged_by, and what they mean.
_JUDGED_BY = (("episode", "episodes"), ("indicator", "the health indicator and its limit"))


@dataclass(frozen=True, eq=False, repr=False)
class Summary:
    """The page of ``gam run`` for a source, and its rows.

    Attributes:
        job: source and method, as they were resolved.
        channels: a row (dict) per channel, the most urgent first: what :func:`gam_db.support` has of it;
            ``status``, ``urgency``, ``needs_attention``, ``judged_by``, ``hi``, ``is_above``, and of its
            newest episode ``episode``, ``onset`` and ``is_open``; ``course``, (points,) the health
            indicator so far, with ``course_from`` and ``last_time``; ``remarks``, sentences.
        machines: a row per machine, ranked, as ``gam_machine`` has it.
        ended: a row per episode that ended.
        programs: what :func:`gam_db.programs` returns, as rows; empty where the source names none.
        siblings: channels that share settings which calibration chose.
        ahead: channels with rows that are later than now, which are left out, and how many.
        sentences: remarks on these.
    """

    job: Job
    channels: list[Row]
    machines: list[Row] = field(default_factory=list)
    ended: list[Row] = field(default_factory=list)
    programs: list[Row] = field(default_factory=list)
    siblings: list[Siblings] = field(default_factory=list)
    ahead: list[Row] = field(default_factory=list)
    sentences: list[str] = field(default_factory=list)

    @property
    def needs_attention(self) -> bool:
        """Tell whether a channel needs attention, or would show no shift (exit code 2)."""
        return need_attention(self.channels) or any(map(is_blind, self.channels))

    @property
    def lacks_data(self) -> bool:
        """Tell whether the data has a problem to fix (exit code 4)."""
        return lack_data(self.channels) or bool(of_programs.unjudged(self.programs) or self.ahead)

    def figures(self) -> dict[str, Any]:
        """Return what ``gam run --json`` prints of the channels."""
        channels = self.channels
        return {
            "channels": [{**row, "course": thinned(row["course"])} for row in channels],
            "machines": self.machines,
            "ended_episodes": self.ended,
            "verdicts": Counter(row["verdict"] for row in channels),
            "chosen": automatic.figures(self.siblings),
            "judged_by_episode": sum(row["judged_by"] == "episode" for row in channels),
            "needs_attention": self.needs_attention,
            **({} if self.job.guess.source.program is None else {"programs": self.programs}),
            "ahead": self.ahead,
        }

    def sections(self, everything: bool = False, shown_in: dt.tzinfo = dt.UTC) -> Iterator[Section]:
        """Yield the sections of its page."""
        yield from _sections(self, everything, shown_in)

    def text(self, everything: bool = False, time_zone: str = "UTC", width: int | None = None) -> str:
        """Return what ``gam run`` prints.

        Args:
            everything: every channel, not only the 40 most urgent, and all remarks (``--all``).
            time_zone: zone of times, such as Europe/Berlin.
            width: in characters; None for that of the terminal, or 80.

        Raises:
            ConfigurationError: there is no such time zone.
        """
        return text_of(self.sections(everything, zone(time_zone)), width)

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__  # what a notebook shows


@public
def summary(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    engine: Any = None,
) -> Summary:
    """Return what ``gam run`` prints: of each channel its verdict, what it sees, its course and remarks.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: of the method; default :class:`gam_db.Parameters`.
        calibration: the healthy part; default the first fifth of each channel.
        alarms: the asked rate and the families; default :class:`gam_db.Alarms`.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open connection.

    Returns:
        ``print(summary)`` prints the page; ``summary.channels`` are its rows, and
        ``summary.needs_attention`` says whether one needs attention. See :class:`gam_db.Summary`.

    Raises:
        UserError: see its subclasses; the message says what to mend.
    """
    method = parameters or Parameters(), calibration or Calibration()
    with borrowed(engine) as session:
        seen = looked_up(source, session)
        study = Study(session, seen.source, *method, short_cuts=True)
        try:
            job = Job(
                _name(source.relation if isinstance(source, (Source, WideSource)) else source),
                dataclasses.replace(seen, source=study.source),
                *method,
                exact=exact_columns(session, study.source, study.columns),
            )
            longest = park_after(None, study.method.kind)
            return summarised(study, job, alarms or Alarms(), longest)
        finally:
            if session is engine:  # it stays open
                study.forget()


def _name(relation: Any) -> str:
    """Return what a source is called: a table or file by its name, all else by what it is."""
    is_named = isinstance(relation, (str, tuple)) or is_file(relation)
    return shown_relation(relation) if is_named else type(relation).__name__


def summarised(study: Study, job: Job, alarms: Alarms, longest: int | None = None) -> Summary:
    """Return the summary of a study; *longest* is as for :func:`findings`."""
    channels = findings(study, alarms, longest)
    ranked = study.table("ranked_machines").sort_by("machine_rank").to_pylist()
    machines = [{_MACHINE.get(name, name): value for name, value in row.items()} for row in ranked]
    ended = study.table("episodes").filter(pc.field("is_open") == 0).to_pylist()
    programs: list[Row] = []
    if study.method.programs is not None:  # by way of Arrow: instants may have a zone
        programs = study.table("program_summary").to_pylist()
    sentences = ahead_sentences(study.ahead, len(channels), study.clock)
    return Summary(job, channels, machines, ended, programs, study.siblings, ahead_of(study), sentences)


def ahead_of(study: Study) -> list[Row]:
    """Return the channels of a study with rows that are later than now, as --json prints them."""
    kind = study.method.kind
    return [{**row, "ahead_to": shown_instant(row["ahead_to"], kind)} for row in study.ahead]


def _sections(of: Summary, everything: bool, shown_in: dt.tzinfo) -> Iterator[Section]:
    job, channels, most = of.job, of.channels, None if everything else options.SHOWN
    samples = sum(row["samples"] for row in channels)
    yield f"{printable(job.name)}: {page.amount(channels)}, {samples:,} samples{job.settings}"
    yield from pools.lines(channels, job.calibration)
    yield from job.lines()
    yield ""
    yield from page.channels(channels[:most], "last_time", "all that is scored", shown_in, everything)
    yield from page.cut(channels, everything, page.counted)
    yield ""
    if len(of.machines) > 1:
        yield from of_machines.lines(of.machines, shown_in, everything)
    yield from _ended(of.ended[:most], shown_in)
    yield from page.cut(of.ended, everything, what=" episodes that ended")
    yield f"verdicts: {page.verdicts(channels)}"
    judged = Counter(row["judged_by"] for row in channels)
    by = [(text, judged[name]) for name, text in _JUDGED_BY if judged[name]]
    words = ", ".join(f"{text}: {count:,}" if len(by) > 1 else text for text, count in by)
    yield f"channels: {page.counted(channels)}{f'; judged by {words}' if words else ''}"
    yield from of_machines.far_above(channels)
    yield from page.unseen(channels)
    lacking = of_programs.lines(of.programs)
    yield from lacking[:most]
    yield from page.cut(lacking, everything, what=" programs")
    if silent := sum(row["silent"] for row in channels):
        yield f"silent: {silent:,}"
    if job.parameters.is_open:
        yield from automatic.lines(of.siblings, everything)
        bins = sorted(Counter(row["bins"] for row in channels).items(), reverse=True)
        yield f"chosen bins: {', '.join(f'{bins} for {count:,}' for bins, count in bins)}"
    yield from page.advice(channels)
    ends = [row["last_time"] for row in channels if isinstance(row["last_time"], int)]
    if ends and (unit := epoch_unit(min(ends), max(ends))):
        like = f"time looks like {SINCE_1970[unit][0]} since 1970, and is taken as a counter"
        yield f"{like}; --time-unit {unit} makes calendar time of it"
    if short := sum(
        row["hi_limit"] is not None and 0 < row["calibration_vectors"] < 8 * row["window"]
        for row in channels
    ):
        yield WORDS["run"]["short"].format(short=short)
    value = getattr(job.guess.source, "value", None)
    if beyond := sum(
        (value or row["channel"]) in job.exact
        and max(abs(row["calibrated_lo"] or 0), abs(row["calibrated_hi"] or 0)) >= EXACT_UP_TO
        for row in channels
    ):
        yield f"{number_of(beyond, 'channel')} of {SENTENCES['beyond']}"
    if not (need_attention(channels) or any(map(is_blind, channels)) or lack_data(channels) or lacking):
        yield "nothing needs attention"
    yield from of.sentences


def _ended(rows: Sequence[Row], zone: dt.tzinfo) -> Iterator[str]:
    """Yield a line for each episode that ended."""
    name = page.name_in(rows)
    for row in rows:
        first, last = (time_text(row[of], zone) for of in ("onset_time", "last_time"))
        proving = ", right after calibration" if row["is_proving"] else ""
        yield f"episode that ended: {name(row)}, from {first} to {last}{proving}"
