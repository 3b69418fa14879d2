"""DuckDB, the embedded default, as an engine; at work it is in session.py."""

from functools import partial

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, Texts, compare_by_bytes, formula
from gam_db.engines.duckdb.reading import instant_of_text, number_of, retyped, seen_formats
from gam_db.engines.types import Types
from gam_db.method.bits import Bits

#: DuckDB rounds nanoseconds to microseconds; the method floors them. Its integer division rounds towards
#: zero, so a rest below zero takes one more; since 1970 there is none. Infinite times are NULL.
_FLOORED = """ THEN NULL WHEN own.EPOCH_NS(:time) >= 0 THEN own.EPOCH_NS(:time) // 1000
    ELSE own.EPOCH_NS(:time) // 1000 - CASE WHEN own.EPOCH_NS(:time) % 1000 < 0 THEN 1 ELSE 0 END END"""


def gathered(numbers: exp.Expr, bound: int) -> exp.Expr:
    """Return one row of bits that has those of the numbers set."""
    return formula("own.BITSTRING_AGG(CAST(:numbers AS INT), 0, :last)", numbers=numbers, last=bound - 1)


def held(bits: exp.Expr, number: exp.Expr) -> exp.Expr:
    """Return the bit of a number."""
    return formula("own.GET_BIT(:bits, CAST(:number AS INT))", bits=bits, number=number)


ENGINE = Engine.named(
    "duckdb",
    types=Types("duckdb", (("TIMESTAMPTZ_NS", "TIMESTAMPTZ(9)"),)),
    texts=Texts(number_of, instant_of_text),
    seen_formats=seen_formats,
    retyped=retyped,
    micros={
        TimeKind.TIMESTAMP: "CASE WHEN own.ISFINITE(:time) THEN own.EPOCH_US(:time) END",
        TimeKind.NANOSECONDS: "CASE WHEN NOT own.ISFINITE(:time)" + _FLOORED,
        TimeKind.NANOSECONDS_WITH_ZONE: (
            "CASE WHEN NOT own.ISFINITE(CAST(:time AS TIMESTAMPTZ))" + _FLOORED
        ),
    },
    bits=Bits(gathered, held),
    rewrites=(partial(compare_by_bytes, exp.var("C")),),
)
