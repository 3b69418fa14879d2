"""Programs of a source: those that its column names, or the columns that look as if they named some."""

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sqlglot import exp

from gam_db.checking.words import extent, number_of, percent
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.settings.source import AnySource, Source, WideSource, parsed_condition, read_from
from gam_db.study import Study

if TYPE_CHECKING:
    from gam_db.checking.look import Look

MOST = 50
"""Different values up to which a column may say which program a machine runs."""
_SHARES = "program_shares"
_SAID_APART = 10  # programs that calibration lacks, each with a sentence of its own

Row = dict[str, Any]


@dataclass(frozen=True)
class Candidate:
    """A column that looks as if it said which program a machine runs."""

    column: str
    programs: int  # different values
    usual_run: int  # lower median of the readings of a run, of one signal of each machine


def add_programs(steps: Pipeline) -> None:
    """Add what each channel runs in calibration and in all; the last step is *program_shares*."""
    add(steps, "check/program_runs")
    add(steps, "check/taught_readings")
    add(steps, "check/program_runs", name="taught_runs", tables={"samples": "taught_readings"})
    add(steps, "check/taught_days")
    add(steps, "check/later_readings")
    add(steps, f"check/{_SHARES}")
    steps.small |= {"program_runs", "taught_runs", "taught_days", "later_readings"}


def add_usual_run(steps: Pipeline) -> None:
    """Add how long runs of a column are, over *readings*; the last step is *usual_run*."""
    add(steps, "check/followed")
    add(steps, "check/program_runs", tables={"samples": "followed"})
    add(steps, "check/usual_run")


def program_rows(study: Study) -> tuple[Row, ...]:
    """Return the programs of each channel; none where no column names them."""
    if study.method.programs is None:
        return ()
    add_programs(study.steps)
    return tuple(study.rows(_SHARES))


def candidates(study: Study, window: int) -> tuple[Candidate, ...]:
    """Return the columns that look as if they said which program a machine runs.

    They are texts or whole numbers that nothing reads, of 2 to 50 values, which stay for at least a
    window of readings at the median and return. Their first rows are looked at first; a table without
    columns of such a type is not looked at again.
    """
    if study.method.programs is not None:
        return ()
    names = list(_possible(study))
    for file in ("first_programs", "distinct_programs"):
        counts = _counted(study, file, names)
        least = 2 if file == "distinct_programs" else 0  # the first rows may be of one shift
        names = [name for name in names if least <= counts[name] <= MOST]
    found = []
    for name in names:
        row = _usual_run(study, name)
        if row is None or row["turns"] is None:
            continue
        if 2 <= row["programs"] <= MOST and row["turns"] > 1 and row["usual_run"] >= window:
            found.append(Candidate(name, row["programs"], row["usual_run"]))
    return tuple(found)


def _possible(study: Study) -> Iterator[str]:
    """Yield columns of texts and whole numbers that say nothing else; also channels of a wide table."""
    source, types = study.source, study.session.engine.types
    read = {source.asset, source.time}
    if isinstance(source, Source):
        read |= {source.channel, source.value}
    conditions = [one for one in (source.where, source.valid_when) if one is not None]
    heeded = {
        column.name.casefold()
        for one in conditions
        for column in parsed_condition(one).find_all(exp.Column)
    }
    for name, type_name in study.columns.items():
        if name in read or name.casefold() in heeded:
            continue
        if types.is_text(type_name) or types.is_whole(type_name):
            yield name


def _counted(study: Study, file: str, names: list[str]) -> Mapping[str, int]:
    if not names:
        return {}
    columns = [template.column(name) for name in names]
    counts = [
        exp.alias_(template.fill("check/distinct_count", {"column": column}), f"count_{place}")
        for place, column in enumerate(columns)
    ]
    slots: dict[str, template.Slot] = {
        "counts": counts,
        "condition": parsed_condition(study.source.where),
    }
    if file == "first_programs":
        slots["columns"] = columns
    query = template.fill(f"check/{file}", slots)
    read_from(study.relation, query)
    (row,) = study.session.rows(query)
    return {name: row[f"count_{place}"] for place, name in enumerate(names)}


def _usual_run(study: Study, column: str) -> Row | None:
    """Return what check/usual_run.sql says of a column; None where nothing else is a reading."""
    source: AnySource = replace(study.source, program=column)
    if isinstance(source, WideSource):
        others = [name for name in source.value_columns if name != column]
        if not others:
            return None
        source = replace(source, channels=others[:1])
    steps = Pipeline()
    steps.add("readings", study.readings_of(source))
    add_usual_run(steps)
    (row,) = study.session.rows(steps.query("usual_run"))
    return row


@dataclass(frozen=True)
class Total:
    """What a source has of one program."""

    program: str
    share: float  # of all samples
    runs: int  # of all machines
    calibration_runs: tuple[int, ...]  # of each machine
    calibration_days: tuple[int, ...]  # of each machine

    def line(self, is_counter: bool) -> str:
        """Return it in words."""
        runs, days = extent(self.calibration_runs), extent(self.calibration_days)
        held = f"{runs} run{'s' * (runs != '1')}"
        if not is_counter:
            held += f" on {days} day{'s' * (days != '1')}"
        each = " each" * (len(self.calibration_runs) > 1)
        ran = f"{percent(self.share)} of the readings in {number_of(self.runs, 'run')}"
        return f"{self.program}: {ran}; calibration: {held}{each}"


def totals(look: "Look") -> list[Total]:
    """Return the programs of a source, the most frequent ones first."""
    samples = sum(row["samples"] for row in look.channels)
    assets = list(dict.fromkeys(row["asset"] for row in look.programs))
    by_program: dict[str, list[Row]] = defaultdict(list)
    for row in look.programs:
        by_program[row["program"]].append(row)
    found = []
    for program, rows in by_program.items():
        most: dict[str, dict[str, int]] = {asset: defaultdict(int) for asset in assets}
        for row in rows:
            # Signals of one machine run the same; what one of them lacks, another may have.
            for name in ("runs", "calibration_runs", "calibration_days"):
                most[row["asset"]][name] = max(most[row["asset"]][name], row[name])
        runs, taught, days = (
            tuple(one[name] for one in most.values())
            for name in ("runs", "calibration_runs", "calibration_days")
        )
        share = sum(row["readings"] for row in rows) / samples
        found.append(Total(program, share, sum(runs), taught, days))
    return sorted(found, key=lambda total: (-total.share, total.program))


#: A subject, its words and the channels concerned.
Remark = tuple[str, dict[str, str], tuple[tuple[str, str], ...]]


def remarks(look: "Look") -> Iterator[Remark]:
    """Yield what is to be known of the programs of a source."""
    for one in look.candidates:
        words = {"column": one.column, "programs": f"{one.programs:,}", "usual": f"{one.usual_run:,}"}
        yield "program_column", words, ()
    lacking: dict[str, list[Row]] = defaultdict(list)
    for row in look.programs:
        if not row["is_taught"] and row["later_readings"]:
            lacking[row["program"]].append(row)
    for program, rows in list(lacking.items())[:_SAID_APART]:
        count = extent([row["later_readings"] for row in rows])
        names = tuple((row["asset"], row["channel"]) for row in rows)
        yield "program_lacking", {"program": program, "count": count}, names
    if (more := len(lacking) - _SAID_APART) > 0:
        yield "programs_lacking", {"more": number_of(more, "further program")}, ()
    if look.method.programs is None:
        return
    named: dict[tuple[str, str], int] = defaultdict(int)
    for row in look.programs:
        named[row["asset"], row["channel"]] += row["readings"]
    without = {
        (row["asset"], row["channel"]): row["samples"] - named[row["asset"], row["channel"]]
        for row in look.channels
    }
    if nameless := sum(without.values()):
        share = percent(nameless / sum(row["samples"] for row in look.channels))
        yield (
            "program_unnamed",
            {"share": share, "column": look.method.programs.column},
            tuple(name for name, count in without.items() if count),
        )
