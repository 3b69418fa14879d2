"""DuckDB, the embedded default, as an engine; at work it is in session.py."""

from functools import partial

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, Texts, formula, settings
from gam_db.engines.duckdb.reading import count_of_text, instant_of_text, is_zoned, number_of, retyped
from gam_db.engines.functions import SIGNAL, macro, signal_rows
from gam_db.engines.rewrites import compare_by_bytes
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


def counted_as_doubles(tree: exp.Expr) -> exp.Expr:
    """Count along an order in DOUBLE, which is as exact for fewer than 2^53 rows.

    Cause: a running aggregate is read off a tree over the sorted rows, and where a partition does not
    begin with one of its nodes each row asks for many of them; integers are added as 128 bits. Symptom:
    their running sum takes twice the time of that of DOUBLE, and six times that of ROW_NUMBER.
    Sums of all else than ``CASE WHEN ... THEN 1 ELSE 0 END`` may be larger, and stay what they are.
    """
    for window in tree.find_all(exp.Window):
        added = window.this.this if isinstance(window.this, exp.Sum) else None
        if window.args.get("order") is not None and isinstance(added, exp.Case):
            values = [*(branch.args["true"] for branch in added.args["ifs"]), added.args.get("default")]
            if all(
                isinstance(literal, exp.Literal) and literal.name in ("0", "1") for literal in values
            ):
                window.this.set("this", exp.cast(added, "DOUBLE"))
    return tree


def of_signal(name: exp.Table, view: exp.Table) -> exp.Create:
    """Return the macro that gives the rows of one signal of a view."""
    return macro(name, SIGNAL, signal_rows(view))


ENGINE = Engine.named(
    "duckdb",
    of_signal=of_signal,
    delays_by_column=True,
    working=settings({"TimeZone": "UTC"}),
    types=Types("duckdb", (("TIMESTAMPTZ_NS", "TIMESTAMPTZ(9)"),)),
    texts=Texts(number_of, instant_of_text, count_of_text),
    zoned=is_zoned,
    retyped=retyped,
    micros={
        TimeKind.TIMESTAMP: "CASE WHEN own.ISFINITE(:time) THEN own.EPOCH_US(:time) END",
        TimeKind.NANOSECONDS: "CASE WHEN NOT own.ISFINITE(:time)" + _FLOORED,
        TimeKind.NANOSECONDS_WITH_ZONE: (
            "CASE WHEN NOT own.ISFINITE(CAST(:time AS TIMESTAMPTZ))" + _FLOORED
        ),
    },
    bits=Bits(gathered, held),
    rewrites=(partial(compare_by_bytes, exp.var("C")), counted_as_doubles),
)
