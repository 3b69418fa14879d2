"""Trino and Athena."""

from gam_db.engines.base import Engine
from gam_db.engines.storage import merged

ENGINE = Engine(
    name="trino",
    title="Trino",
    dialect="trino",
    transactions=False,
    limits="gam-db does not connect to it; it prints the SQL. No statement was run. "
    "Times are exact to the millisecond.",
    # To the millisecond: DATE_DIFF knows no finer unit.
    micros="own.DATE_DIFF('millisecond', CAST('1970-01-01 00:00:00' AS TIMESTAMP), "
    "CAST(:time AS TIMESTAMP)) * 1000",
    instant="own.FROM_UNIXTIME_NANOS(:micros * 1000)",
    fill=merged,
)
