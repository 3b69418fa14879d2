"""Programs: the work of a machine, by a column of the source (both sides, section 5).

The number of the program is the highest digit of a cell's key, so later steps look keys up as usual.
Without such a column this module adds no step and no column.
"""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import wrong
from gam_db.method.adding import OfSet, add
from gam_db.method.slots import all_present, cell_key, weight_at
from gam_db.settings.parameters import LARGEST_KEY, Parameters
from gam_db.settings.source import Programs, TimeNode

#: Samples with the number of their program: of all that calibration holds, and of those judged.
TAUGHT, JUDGED = "program_samples", "judged_samples"

_PROGRAM, _NUMBER = "program", "program_no"


def has_programs(readings: exp.Query) -> bool:
    """Tell whether some readings have a column of programs."""
    return _PROGRAM in readings.named_selects


def identified_slots(read: exp.Expr, has_programs: bool) -> dict[str, template.Slot]:
    """Return the slots of source/identified.sql: which readings are read, and what travels with them."""
    return {"read": read, "programs": _carried(has_programs)}


def add_samples(steps: Pipeline, programs: Programs | None) -> None:
    """Add the samples, of which each instant has one: *collapsed* and *samples*."""
    conflicting = template.fill("source/conflicting")
    if programs is not None:
        program = exp.column(_PROGRAM, table="repeated")
        differing = exp.LT(this=exp.Min(this=program), expression=exp.Max(this=program.copy()))
        conflicting = exp.or_(conflicting, differing)
    slots: dict[str, template.Slot] = {
        "conflicting": conflicting,
        "programs": _carried(programs is not None),
        "gathered": gathered("repeated", programs),
    }
    add(steps, "source/collapsed", slots)
    add(steps, "source/samples", {"programs": _carried(programs is not None)})


def gathered(table: str, programs: Programs | None) -> list[exp.Expr]:
    """Return the least program of the readings of one instant, as a column: of whole numbers by size."""
    if programs is None:
        return []
    program = ordered_by(exp.column(_PROGRAM, table=table), programs.is_whole)
    least: exp.Expr = exp.Min(this=program)
    return [exp.alias_(exp.cast(least, "VARCHAR") if programs.is_whole else least, _PROGRAM)]


def ordered_by(program: exp.Expr, is_whole: bool) -> exp.Expr:
    """Return what programs are ordered by: texts by their bytes, whole numbers by size."""
    return exp.cast(program, "BIGINT") if is_whole else program


def add_taught_programs(steps: Pipeline, programs: Programs | None) -> None:
    """Add the programs of calibration, numbered, and its samples with these numbers."""
    if programs is None:
        return
    ordered = ordered_by(exp.column(_PROGRAM), programs.is_whole)
    add(steps, "program/taught_programs", {"ordered": ordered})
    add(steps, "program/program_samples", name=TAUGHT, tables={"numbered_programs": "taught_programs"})


def add_judged_programs(set_steps: OfSet) -> None:
    """Add what calibration knows of the programs of one set, and samples of those that are judged."""
    if set_steps.method.programs is None:
        return
    set_steps.add("program/programs", {"weight": weight_of(set_steps.setting)})
    set_steps.add("program/judged_programs")
    set_steps.add(
        "program/program_samples", name=JUDGED, tables={"numbered_programs": "judged_programs"}
    )


def coded(set_steps: OfSet, samples: str) -> tuple[dict[str, template.Slot], dict[str, str]]:
    """Return slots and tables of a file that codes samples, which carry the number of their program.

    Its slot ``settings`` has the settings of a channel that are columns.
    """
    columns = [exp.alias_(exp.column(name, table="scale"), name) for name in set_steps.method.columns]
    if set_steps.method.programs is None:
        return {"settings": columns}, {}
    number = exp.alias_(exp.column(_NUMBER, table="sampled"), _NUMBER)
    return {"settings": [*columns, number]}, {"samples": samples}


def numbers(set_steps: OfSet) -> list[exp.Expr]:
    """Return the column of codes that holds the number of the program, if there is one."""
    return [] if set_steps.method.programs is None else [exp.column(_NUMBER)]


def keyed(set_steps: OfSet) -> dict[str, template.Slot]:
    """Return the slots of a file that makes keys of codes: which vectors have one, and the key.

    Nothing where there are no programs: the slots follow from the parameters then.
    """
    if set_steps.method.programs is None:
        return {}
    setting = set_steps.setting
    radix = exp.column("radix") if "radix" in set_steps.method.columns else None
    term = template.fill("program/program_term", {"weight": weight_at(setting, setting.m, radix)})
    return {
        "is_present": exp.and_(
            all_present(setting), template.fill("program/fits", {"most": most_of(setting)})
        ),
        "cell_key": template.added([cell_key(setting, radix=radix), term]),
    }


def weight_of(setting: Parameters) -> int:
    """Return by how much the keys of two programs differ at least: R^m."""
    weight: int = setting.radix**setting.m
    return weight


def most_of(setting: Parameters) -> int:
    """Return the largest number of a program with which every key fits into 64 bits."""
    return LARGEST_KEY // weight_of(setting) - 1


def check_programs(setting: Parameters, count: int) -> None:
    """Refuse (ParameterError) more programs than the keys of cells have room for."""
    most = most_of(setting) + 1
    if count > most:
        raise wrong("too_many_programs", count=count, most=most, m=setting.m, bins=setting.grid)


def _carried(has_programs: bool) -> list[exp.Expr]:
    return [exp.column(_PROGRAM)] * has_programs


def add_program_summary(steps: Pipeline, programs: Programs, instant_of: TimeNode) -> None:
    """Add what each channel ran, in calibration and since; the last step is *program_summary*."""
    add(steps, "program/ran_programs")
    columns = {name: exp.column(name, table="counted") for name in ("first_time", "last_time")}
    slots: dict[str, template.Slot] = {name: instant_of(column) for name, column in columns.items()}
    slots["ordered"] = ordered_by(exp.column(_PROGRAM, table="counted"), programs.is_whole)
    add(steps, "program/program_summary", slots)
