"""The forms that must agree, behind one call: each answers the same question with plain rows.

The reference is the NumPy count, which shares no code with the SQL; the others run gam_db on an engine.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

import pyarrow as pa

import comparisons
import engines
import gam_db
import reference
from gam_db.study import Study

Row = tuple[str, str, int, float | None]
#: The same with the program that a machine runs, a text or a whole number.
ProgramRow = tuple[str, str, int, float | None, Any]
Answer = list[dict[str, Any]]
Form = Callable[[str, list[Row], gam_db.Parameters, gam_db.Calibration], Answer]

#: question -> (call of the reference, call of gam_db)
QUESTIONS = {
    "health_indicator": (reference.health_indicator, gam_db.health_indicator),
    "health_at_buckets": (reference.buckets, gam_db.health_at_buckets),
    "support": (reference.support, gam_db.support),
    "certificate": (reference.certificate, gam_db.certificate),
}

#: question -> the step that answers it
STEPS = {
    "health_indicator": "health_indicator",
    "health_at_buckets": "bucket_health",
    "support": "support_summary",
    "certificate": "certificate",
}


def arrow(rows: Sequence[Row] | Sequence[ProgramRow]) -> pa.Table:
    """Return rows as the Arrow table of a long source; a fifth value is the program of a row."""
    columns = list(zip(*rows, strict=True)) if rows else [(), (), (), ()]
    types = [pa.string(), pa.string(), pa.int64(), pa.float64()]
    names = ["asset", "channel", "time", "value"]
    if len(columns) > len(names):
        is_whole = any(isinstance(program, int) for program in columns[4])
        names, types = [*names, "program"], [*types, pa.int64() if is_whole else pa.string()]
    arrays = [pa.array(list(c), t) for c, t in zip(columns, types, strict=True)]
    return pa.table(dict(zip(names, arrays, strict=True)))


def by_reference(
    question: str, rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> Answer:
    """Answer by the NumPy reference."""
    return QUESTIONS[question][0](rows, parameters, calibration)


def all_by_reference(
    rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> dict[str, Answer]:
    """Answer every question by the NumPy reference."""
    return reference.answers(rows, parameters, calibration)


def by_engine(engine: str) -> Form:
    """Return what answers by the exact form on an engine, through the public call."""

    def answer(
        question: str, rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
    ) -> Answer:
        session = engines.session(engine)
        with session.lent(arrow(rows)) as table:
            source = gam_db.Source(table.name)
            found: Answer = QUESTIONS[question][1](source, parameters, calibration, session).to_pylist()
        comparisons.compared(engine, "exact", rows, parameters, calibration)
        return found

    return answer


def all_by_engine(
    engine: str, rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> dict[str, Answer]:
    """Answer every question by the exact form on an engine, from one study."""
    session = engines.session(engine)
    comparisons.compared(engine, "exact", rows, parameters, calibration)
    with session.lent(arrow(rows)) as table:
        study = Study(session, gam_db.Source(table.name), parameters, calibration)
        try:
            return {question: study.table(step).to_pylist() for question, step in STEPS.items()}
        finally:
            study.forget()


def made(parameters: dict[str, Any], calibration: dict[str, Any]) -> tuple[Any, Any]:
    """Return the dataclasses of a drawn case."""
    overrides = [gam_db.Override(**override) for override in parameters.get("overrides", [])]
    rules = {
        pattern: None if rule is None else gam_db.Calibration(**rule)
        for pattern, rule in calibration.get("overrides", {}).items()
    }
    return (
        gam_db.Parameters(**{**parameters, "overrides": overrides}),
        gam_db.Calibration(**{**calibration, "overrides": rules}),
    )


def assert_same(expected: Answer, found: Answer, what: str = "") -> None:
    """Compare two answers: integers and texts exactly, doubles to 1e-9 of their size."""
    assert len(expected) == len(found), f"{what}: {len(expected)} rows expected, {len(found)} found"
    for number, (left, right) in enumerate(zip(expected, found, strict=True)):
        assert left.keys() == right.keys(), f"{what}: columns differ"
        for column, value in left.items():
            other = right[column]
            if isinstance(value, float) and isinstance(other, float):
                same = math.isclose(value, other, rel_tol=1e-9, abs_tol=1e-9)
            else:
                same = value == other
            assert same, f"{what} row {number} column {column}: expected {value!r}, found {other!r}"
