"""Snowflake."""

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine
from gam_db.engines.storage import Storage, clustered

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
    storage=Storage("inside", properties=clustered),
)
