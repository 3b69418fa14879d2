"""What the types of columns mean, on every engine that is worked on."""

import pytest

from gam_db.clock import TimeKind
from gam_db.engines import engine_named

#: (engine, what its columns are) -> names of types; times are called as their kind
TYPES = {
    ("duckdb", "timestamp"): [
        "TIMESTAMP",
        "TIMESTAMP_S",
        "TIMESTAMP_MS",
        "DATE",
    ],
    ("duckdb", "nanoseconds"): [
        "TIMESTAMP_NS",
    ],
    ("duckdb", "timestamp_with_zone"): [
        "TIMESTAMP WITH TIME ZONE",
    ],
    ("duckdb", "nanoseconds_with_zone"): [
        "TIMESTAMPTZ_NS",
    ],
    ("duckdb", "an integer"): [
        "TINYINT",
        "SMALLINT",
        "INTEGER",
        "BIGINT",
        "HUGEINT",
        "UTINYINT",
        "USMALLINT",
        "UINTEGER",
        "UBIGINT",
        "UHUGEINT",
    ],
    ("duckdb", "a number"): [
        "DOUBLE",
        "FLOAT",
        "DECIMAL(10,2)",
    ],
    ("duckdb", "nothing"): [
        "DECIMAL(10,2)[]",
        "VARCHAR[]",
        "BOOLEAN",
        "BLOB",
        "TIME",
        "INTERVAL",
        "STRUCT(a INTEGER)",
        "MAP(VARCHAR, INTEGER)",
        "JSON",
        "BIT",
        "NULL",
        '"NULL"',
        "BIGNUM",
        "TIME WITH TIME ZONE",
        "UNION(a INTEGER)",
        "VARIANT",
        "GEOMETRY",
    ],
    ("duckdb", "a text"): [
        "VARCHAR",
    ],
    ("duckdb", "a name"): [
        "ENUM('a', 'b')",
        "UUID",
        "ENUM('it''s', 'b)')",
    ],
    ("clickhouse", "an integer"): [
        "Int8",
        "Int64",
        "UInt64",
        "Int256",
        "Nullable(Int32)",
        "UInt8",
        "Nullable(UInt64)",
    ],
    ("clickhouse", "a number"): [
        "Float32",
        "Float64",
        "BFloat16",
        "Decimal(10, 2)",
        "Nullable(Decimal(18, 4))",
        "Nullable(BFloat16)",
    ],
    ("clickhouse", "a text"): [
        "LowCardinality(String)",
        "LowCardinality(Nullable(String))",
        "String",
    ],
    ("clickhouse", "a name"): [
        "FixedString(8)",
        "LowCardinality(FixedString(2))",
        "Enum8('a' = 1, 'b' = 2)",
        "Enum16('a' = 1)",
        "Nullable(Enum8('a)' = 1))",
        "UUID",
    ],
    ("clickhouse", "nothing"): [
        "Bool",
        "Array(Int8)",
        "Nullable(Bool)",
        "Tuple(Int8, String)",
        "Map(String, Int8)",
        "Time",
        "IPv4",
        "Nullable(Nothing)",
        "JSON",
        "Variant(Int8, String)",
        "Dynamic",
        "Nested(a Int8)",
        "AggregateFunction(sum, Int8)",
        "Point",
        "Array(DateTime)",
    ],
    ("clickhouse", "timestamp"): [
        "Date",
        "Date32",
        "DateTime",
        "DateTime64(3)",
        "Nullable(DateTime64(6))",
        "LowCardinality(Nullable(DateTime))",
    ],
    ("clickhouse", "timestamp_with_zone"): [
        "DateTime('UTC')",
        "DateTime64(6, 'Europe/Berlin')",
        "Nullable(DateTime('UTC'))",
        "DateTime('Asia/Tokyo')",
    ],
    ("clickhouse", "nanoseconds"): [
        "DateTime64(9)",
        "DateTime64(7)",
    ],
    ("clickhouse", "nanoseconds_with_zone"): [
        "DateTime64(9, 'UTC')",
        "Nullable(DateTime64(9, 'UTC'))",
    ],
    ("postgres", "an integer"): [
        "smallint",
        "integer",
        "bigint",
    ],
    ("postgres", "a number"): [
        "numeric",
        "numeric(10,2)",
        "real",
        "double precision",
    ],
    ("postgres", "a text"): [
        "text",
        "character varying",
        "character varying(20)",
        "character(5)",
        "name",
        "citext",
    ],
    ("postgres", "a name"): [
        "uuid",
        "enum",
    ],
    ("postgres", "timestamp"): [
        "timestamp without time zone",
        "timestamp(3) without time zone",
        "date",
    ],
    ("postgres", "timestamp_with_zone"): [
        "timestamp with time zone",
        "timestamp(3) with time zone",
    ],
    ("postgres", "nothing"): [
        "time without time zone",
        "time(3) without time zone",
        "time with time zone",
        "interval",
        "boolean",
        "json",
        "jsonb",
        "bytea",
        "integer[]",
        "text[]",
        "oid",
        "money",
        "int4range",
        "inet",
        "bit(3)",
        "bit varying(3)",
        "point",
        '"char"',
        "xml",
        "tsvector",
        "macaddr",
        "public.mood",
        "hstore",
        "pg_lsn",
        "record",
        "regclass",
        "box",
        "numeric(10,2)[]",
    ],
    ("spark", "timestamp_with_zone"): [
        "timestamp",
        "timestamp_ltz",
    ],
    ("spark", "timestamp"): [
        "timestamp_ntz",
        "date",
    ],
    ("spark", "an integer"): [
        "tinyint",
        "smallint",
        "int",
        "bigint",
    ],
    ("spark", "a number"): [
        "float",
        "double",
        "decimal(10,2)",
    ],
    ("spark", "a text"): [
        "string",
        "string collate UTF8_LCASE",
        "varchar(10)",
        "char(3)",
    ],
    ("spark", "nothing"): [
        "boolean",
        "binary",
        "array<int>",
        "map<string,int>",
        "struct<a:int>",
        "void",
        "interval day to second",
        "variant",
        "interval year to month",
    ],
    ("mariadb", "an integer"): [
        "tinyint(4)",
        "int(11)",
        "bigint(20) unsigned",
        "tinyint(1)",
        "int(10) unsigned zerofill",
    ],
    ("mariadb", "a number"): [
        "double",
        "float",
        "decimal(10,2)",
    ],
    ("mariadb", "a text"): [
        "varchar(20)",
        "char(3)",
        "text",
        "longtext",
        "mediumtext",
    ],
    ("mariadb", "a name"): [
        "enum('a','b')",
        "uuid",
    ],
    ("mariadb", "timestamp"): [
        "datetime(6)",
        "datetime",
        "date",
    ],
    ("mariadb", "timestamp_with_zone"): [
        "timestamp",
        "timestamp(3)",
    ],
    ("mariadb", "nothing"): [
        "time",
        "year(4)",
        "json",
        "blob",
        "set('a')",
        "double unsigned",
    ],
}


@pytest.mark.parametrize(("engine", "what"), TYPES)
def test_types_mean_what_they_are(engine: str, what: str) -> None:
    types = engine_named(engine).types
    times = {kind.name.lower(): kind for kind in TimeKind} | {"an integer": TimeKind.COUNTER}
    for name in TYPES[engine, what]:
        assert types.time_kind(name) is times.get(what), name
        assert types.is_numeric(name) is (what in ("an integer", "a number")), name
        assert types.is_name(name) is (what in ("an integer", "a text", "a name")), name
        assert types.is_text(name) is (what == "a text"), name
