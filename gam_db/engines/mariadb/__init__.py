"""MariaDB 10.11 and later; times are DATETIME(6) in UTC, or integers."""

from functools import partial

from sqlglot import exp

from gam_db.engines.base import Engine, compare_by_bytes, escape_by_backslash
from gam_db.engines.storage import Storage
from gam_db.engines.types import Types

#: A collation by bytes, in which a blank at the end counts.
COLLATION = "utf8mb4_nopad_bin"


def quote_names(tree: exp.Expr) -> exp.Expr:
    """Quote all names.

    Cause: more words are reserved than elsewhere. Symptom: a syntax error at ``delayed``, ``offset``.
    """
    for name in tree.find_all(exp.Identifier):
        name.set("quoted", True)
    return tree


def floor_to_double(tree: exp.Expr) -> exp.Expr:
    """Let FLOOR give a double.

    Cause: of a double it gives one of as many digits as seem enough. Symptom: "out of range" for whole
    numbers beyond 2^53, where a step is kept.
    """
    for floor in list(tree.find_all(exp.Floor)):
        if not isinstance(floor.parent, exp.Cast):
            floor.replace(exp.cast(floor.copy(), "DOUBLE"))
    return tree


ENGINE = Engine.named(
    "mariadb",
    types=Types("mysql"),
    storage=Storage(
        comments="inside",
        view_comments=False,
        properties=lambda _: [exp.CollateProperty(this=exp.var(COLLATION))],
        index=False,
    ),
    rewrites=(
        partial(compare_by_bytes, exp.var(COLLATION)),
        escape_by_backslash,
        quote_names,
        floor_to_double,
    ),
)
