"""MariaDB 10.11 and later; times are DATETIME(6) in UTC, TIMESTAMP, or integers."""

from functools import partial

from sqlglot import exp

from gam_db import data
from gam_db.clock import TimeKind
from gam_db.composing import template
from gam_db.engines.base import Engine, called, settings
from gam_db.engines.rewrites import compare_by_bytes, escape_by_backslash
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


#: Text literals are of the character set of the session, which has to be that of the collation.
_NAMES = exp.Command(this="SET", expression="NAMES utf8mb4")

_BLOCK = (
    "BEGIN NOT ATOMIC IF EXISTS ({}) THEN SIGNAL SQLSTATE '45000' SET MESSAGE_TEXT = {}; END IF; END"
)
_OF_SESSION = (
    "{column} is a TIMESTAMP, which each session reads in its own zone; make the script anew with "
    "--time-kind 'timestamp with time zone'"
)
_OF_CALENDAR = (
    "{column} is no counter; make the script anew with --time-kind timestamp, or for a TIMESTAMP "
    "'timestamp with time zone'"
)


def guard(table: exp.Table, column: str, kind: TimeKind) -> exp.Expr:
    """Return what stops a script whose time column is of another type than the script was made for.

    Cause: a TIMESTAMP is shown in the zone of the session, and a cast to an integer makes digits of a
    calendar time. Symptom: a view gives other rows to a reader in another zone than the one in which
    its tables were made; times such as 20261025080000.
    """
    schema = template.text(table.db) if table.db else called("DATABASE")
    slots: dict[str, template.Slot] = {"schema": schema, "column": template.text(column)}
    others = ("timestamp", "datetime", "date", "time") if kind.is_counter else ("timestamp",)
    slots |= {"table": template.text(table.name), "is_other": exp.column("data_type").isin(*others)}
    query = template.fill("export/timestamp_columns", slots)
    words = _OF_CALENDAR if kind.is_counter else _OF_SESSION
    message = template.text(words.format(column=column))
    texts = [node.sql(dialect="mysql") for node in (query, message)]
    body = template.text(_BLOCK.format(*texts)).sql(dialect="mysql")
    return exp.Command(this="EXECUTE", expression=f"IMMEDIATE {body}")


#: The collation of the database itself may hold few signs.
_BY_BYTES = exp.CollateProperty(this=exp.var(COLLATION))

_AT_WORK = data.table("gam_db.engines.mariadb", "mariadb.toml")["settings"]

ENGINE = Engine.named(
    "mariadb",
    types=Types("mysql"),
    working=settings(_AT_WORK, "SESSION"),
    opening=(_NAMES,),
    guard=guard,
    reads_first=True,
    storage=Storage(
        comments="inside",
        view_comments=False,
        properties=lambda _: [_BY_BYTES],
        temporary=(_BY_BYTES,),
        index=False,
    ),
    rewrites=(
        partial(compare_by_bytes, exp.var(COLLATION)),
        escape_by_backslash,
        quote_names,
        floor_to_double,
    ),
)
