"""Programs of a source: those that its column names, or the columns that look as if they named some."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.settings.source import AnySource, Source, WideSource, parsed_condition, read_from
from gam_db.study import Study

MOST = 50
"""Different values up to which a column may say which program a machine runs."""
_SHARES = "program_shares"
_AT_MOST = 10  # columns whose runs are looked at

Row = dict[str, Any]


@dataclass(frozen=True)
class Candidate:
    """A column that looks like the program of a machine."""

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
    """Return the columns that look like the program of a machine.

    They are texts or whole numbers that nothing reads, of 2 to 50 values, which stay for at least a
    window of readings at the median and return; ten such columns at most are looked at whole. Their
    first rows are looked at before; a table without columns of such a type is not looked at again.
    """
    if study.method.programs is not None:
        return ()
    # A signal of a wide table may say it, too; one of two values is a switch.
    signals = study.source.value_columns
    names = sorted(_possible(study), key=lambda name: name in signals)
    counts = _counted(study, "first_programs", names)
    names = [name for name in names if counts[name] <= MOST]
    counts = _counted(study, "distinct_programs", names)
    names = [name for name in names if 2 + (name in signals) <= counts[name] <= MOST]
    columns = []
    for name in names[:_AT_MOST]:
        row = _usual_run(study, name)
        if row is None or row["turns"] is None:
            continue
        if 2 <= row["programs"] <= MOST and row["turns"] > 1 and row["usual_run"] >= window:
            columns.append(Candidate(name, row["programs"], row["usual_run"]))
    return tuple(columns)


def _possible(study: Study) -> Iterator[str]:
    """Yield columns of texts and whole numbers without another role; also channels of a wide table."""
    source, types = study.source, study.session.engine.types
    read = {source.asset, source.time}
    if isinstance(source, Source):
        read |= {source.channel, source.value}
    conditions = [text for text in (source.where, source.valid_when) if text is not None]
    heeded = {
        column.name.casefold()
        for condition in conditions
        for column in parsed_condition(condition).find_all(exp.Column)
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
    """Return the result of check/usual_run.sql for a column; None if no other column is a reading."""
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
