"""DuckDB, the embedded default, as an engine; at work it is in duckdb_session.py."""

from sqlglot import exp

from gam_db.bits import Bits
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, Texts, called
from gam_db.engines.duckdb_reading import instant_of_text, number_of, retyped, seen_formats
from gam_db.engines.types import Types

_NANOSECONDS = (TimeKind.NANOSECONDS, TimeKind.NANOSECONDS_WITH_ZONE)


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds, NULL for infinite times.

    DuckDB rounds nanoseconds to microseconds; the method floors them. Its integer division rounds
    towards zero, so a rest below zero takes one more.
    """
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
    texts=Texts(number_of, instant_of_text),
    seen_formats=seen_formats,
    retyped=retyped,
    micros=micros_of,
    instant=instant_of,
    flow_hint=True,
    reads_files=True,
    unpivots=True,
    macros=True,
    bits=Bits(gathered, held),
)
