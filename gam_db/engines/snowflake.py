"""Snowflake."""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine
from gam_db.engines.storage import Definition, added_with_notes, clustered, with_notes


def define(definition: Definition) -> list[exp.Expr]:
    """Return a table clustered by its key, with comments inside."""
    return with_notes(definition, [clustered(definition)])


ENGINE = Engine(
    name="snowflake",
    title="Snowflake",
    dialect="snowflake",
    limits="gam-db does not connect to it; it prints the SQL. No statement was run.",
    micros="own.DATE_PART(EPOCH_MICROSECOND, :time)",
    instant={
        TimeKind.TIMESTAMP: "own.TO_TIMESTAMP_NTZ(:micros, 6)",
        TimeKind.TIMESTAMP_WITH_ZONE: "own.TO_TIMESTAMP_LTZ(:micros, 6)",
    },
    define=define,
    extend=added_with_notes,
)
