"""DuckDB, the embedded default, as an engine; its session is in duckdb_session.py."""

from sqlglot import exp

from gam_db import template
from gam_db.bits import Bits
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter
from gam_db.engines.types import Types

_NANOSECONDS = (TimeKind.NANOSECONDS, TimeKind.NANOSECONDS_WITH_ZONE)


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds, NULL for infinite times.

    DuckDB rounds nanoseconds to microseconds; the method floors them. Its integer division rounds
    towards zero, so a rest below zero takes one more.
    """
    if kind.is_counter:
        return counter(column)
    if kind in _NANOSECONDS:
        nanos = called("EPOCH_NS", column)
        thousand, zero = exp.Literal.number(1000), exp.Literal.number(0)
        rest = exp.Mod(this=nanos.copy(), expression=thousand.copy())
        micros: exp.Expr = exp.Sub(
            this=exp.IntDiv(this=nanos, expression=thousand),
            expression=exp.Case(
                ifs=[exp.If(this=exp.LT(this=rest, expression=zero), true=exp.Literal.number(1))],
                default=zero.copy(),
            ),
        )
    else:
        micros = called("EPOCH_US", column)
    dated = exp.cast(column.copy(), "TIMESTAMPTZ") if kind is TimeKind.NANOSECONDS_WITH_ZONE else column
    return exp.Case(ifs=[exp.If(this=called("ISFINITE", dated.copy()), true=micros)])


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds, with a zone where the source has one."""
    if kind.is_counter:
        return micros
    if kind.has_zone:
        return called("MAKE_TIMESTAMPTZ", micros)
    return called("MAKE_TIMESTAMP", micros)


def gathered(numbers: exp.Expr, bound: int) -> exp.Expr:
    """Return one row of bits that has those of the numbers set."""
    least, most = exp.Literal.number(0), exp.Literal.number(bound - 1)
    return called("BITSTRING_AGG", exp.cast(numbers, "INT"), least, most)


def held(bits: exp.Expr, number: exp.Expr) -> exp.Expr:
    """Return the bit of a number."""
    return called("GET_BIT", bits, exp.cast(number, "INT"))


ENGINE = Engine(
    name="duckdb",
    title="DuckDB",
    dialect="duckdb",
    oldest="2.0",
    limits="One process at a time can write a file.",
    types=Types("duckdb", (("TIMESTAMPTZ_NS", "TIMESTAMPTZ(9)"),)),
    micros_of=micros_of,
    instant_of=instant_of,
    flow_hint=True,
    reads_files=True,
    unpivots=True,
    macros=True,
    bits=Bits(gathered, held),
)


def file_reader(path: str) -> exp.Expr:
    """Return the node that reads a Parquet or CSV file by its path.

    Cause: Parquet's statistics leave NaN out, and DuckDB trusts them. Symptom: where all other values of
    a column lie between -1e300 and 1e300, the test for missing ones is optimised away, and NaN counts as
    a reading (seen on files that PyArrow wrote; DuckDB's own have no statistics then).
    """
    if path.lower().endswith((".csv", ".tsv", ".csv.gz", ".tsv.gz", ".csv.zst")):
        return exp.Table(this=called("READ_CSV", template.text(path)))
    with_nan = exp.EQ(this=exp.column("can_have_nan"), expression=exp.true())
    return exp.Table(this=called("READ_PARQUET", template.text(path), with_nan))
