"""What ``gam run`` prints, called from Python, too."""

import dataclasses
import datetime as dt
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
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
    """What ``gam run`` says of a source: printed it is that page, and its rows are here.

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
        sentences: what is to be said of these.
    """

    job: Job
    channels: list[Row]
    machines: list[Row]
    ended: list[Row]
    programs: list[Row]
    siblings: list[Siblings]
    ahead: list[Row]
    sentences: list[str]

    @property
    def needs_attention(self) -> bool:
        """Tell whether a channel needs attention, or would show no shift (exit code 2)."""
        return need_attention(self.channels) or any(map(is_blind, self.channels))

    @property
    def lacks_data(self) -> bool:
        """Tell whether something of the data has to be mended (exit code 4)."""
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

    def show(self, out: page.Out, everything: bool = False, shown_in: dt.tzinfo = dt.UTC) -> None:
        """Print it."""
        more = (self.siblings, self.programs, self.machines, self.ended)
        show(out, self.job, self.channels, everything, shown_in, *more)
        page.say(out, *self.sentences)

    def text(self, everything: bool = False, time_zone: str = "UTC", width: int | None = None) -> str:
        """Return what ``gam run`` prints.

        Args:
            everything: every channel, not only the 40 most urgent, and all remarks (``--all``).
            time_zone: in which times are shown, such as Europe/Berlin.
            width: in characters; None for that of the terminal, or 80.

        Raises:
            ConfigurationError: there is no such time zone.
        """
        out = page.text_console(width)
        self.show(out, everything, zone(time_zone))
        return str(out.file.getvalue())  # type: ignore[attr-defined]

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
    """Return what is found of a study; *longest* is as for :func:`findings`."""
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


def show(
    out: page.Out,
    job: Job,
    channels: Sequence[Row],
    everything: bool = False,
    shown_in: dt.tzinfo = dt.UTC,
    siblings: Sequence[Siblings] = (),
    programs: Sequence[Row] = (),
    machines: Sequence[Row] = (),
    ended: Sequence[Row] = (),
) -> None:
    """Print what was found of each channel, what calibration chose for siblings, and what it lacks."""
    samples = sum(row["samples"] for row in channels)
    page.say(out, f"{printable(job.name)}: {page.amount(channels)}, {samples:,} samples{job.settings}")
    page.say(out, *pools.lines(channels, job.calibration))
    page.say(out, *job.lines())
    out.print()
    shown = channels if everything else channels[: options.SHOWN]
    page.channels(out, shown, "last_time", "all that is scored", shown_in, everything)
    page.cut(out, channels, everything, page.counted)
    out.print()
    if len(machines) > 1:
        of_machines.show(out, machines, shown_in, everything)
    page.say(out, *_ended(ended if everything else ended[: options.SHOWN], shown_in))
    page.cut(out, ended, everything, what=" episodes that ended")
    page.say(out, f"verdicts: {page.verdicts(channels)}")
    judged = Counter(row["judged_by"] for row in channels)
    by = [(text, judged[name]) for name, text in _JUDGED_BY if judged[name]]
    words = ", ".join(f"{text}: {count:,}" if len(by) > 1 else text for text, count in by)
    page.say(out, f"channels: {page.counted(channels)}{f'; judged by {words}' if words else ''}")
    page.say(out, *of_machines.far_above(channels))
    page.say(out, *page.unseen(channels))
    lacking = of_programs.lines(programs)
    page.say(out, *(lacking if everything else lacking[: options.SHOWN]))
    page.cut(out, lacking, everything, what=" programs")
    if silent := sum(row["silent"] for row in channels):
        page.say(out, f"silent: {silent:,}")
    if job.parameters.is_open:
        page.say(out, *automatic.lines(siblings, everything))
        taken = sorted(Counter(row["bins"] for row in channels).items(), reverse=True)
        page.say(out, f"bins taken: {', '.join(f'{bins} for {count:,}' for bins, count in taken)}")
    page.say(out, *page.advice(channels))
    ends = [row["last_time"] for row in channels if isinstance(row["last_time"], int)]
    if ends and (unit := epoch_unit(min(ends), max(ends))):
        like = f"time looks like {SINCE_1970[unit][0]} since 1970, and is taken as a counter"
        page.say(out, f"{like}; --time-unit {unit} makes calendar time of it")
    if short := sum(
        row["hi_limit"] is not None and 0 < row["calibration_vectors"] < 8 * row["window"]
        for row in channels
    ):
        page.say(out, page.WORDS["run"]["short"].format(short=short))
    value = getattr(job.guess.source, "value", None)
    if beyond := sum(
        (value or row["channel"]) in job.exact
        and max(abs(row["calibrated_lo"] or 0), abs(row["calibrated_hi"] or 0)) >= EXACT_UP_TO
        for row in channels
    ):
        page.say(out, f"{number_of(beyond, 'channel')} of {SENTENCES['beyond']}")
    if not (need_attention(channels) or any(map(is_blind, channels)) or lack_data(channels) or lacking):
        page.say(out, "nothing needs attention")
    page.say(out, page.legend(channels, everything))


def _ended(rows: Sequence[Row], zone: dt.tzinfo) -> Iterator[str]:
    """Yield a line for each episode that ended."""
    name = page.name_in(rows)
    for row in rows:
        first, last = (page.time_text(row[of], zone) for of in ("onset_time", "last_time"))
        proving = ", right after calibration" if row["is_proving"] else ""
        yield f"episode that ended: {name(row)}, from {first} to {last}{proving}"
