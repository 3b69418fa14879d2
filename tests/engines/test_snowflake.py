"""Snowflake's text on two relatives, fakesnow and Databend: the integers of the specification, and runs.

What a relative has not is taken out in :mod:`snowflake_relatives`, which names it; what is printed for
Snowflake stays as it is. Neither relative shows its types, collations, limits and locks. What
calibration froze is copied from DuckDB, since gam-db does not connect to Snowflake.
"""

from dataclasses import replace
from typing import Any

import duckdb
import pytest
from hypothesis import given, settings
from sqlglot import exp

import engines
import gam_db
import harness
import scripts
import test_run_sql as runs
from batches import History, history
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.export.monitor import rendered
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.migrations import rendered as migrations
from gam_db.stored.schema.tables import TABLES, StateTables
from harness import Row
from snowflake_relatives import RELATIVES, SNOWFLAKE, SnowflakeDriver, SnowflakeError, relative, version
from strategies import Case, cases
from test_spec import GROUPS, compare_all

#: What this file runs, and how its version is found; see test_engines.py.
RUNS = {"snowflake": version}

#: The fleet of the specification in the first set; the others take minutes.
FLEET = "4 cases: m=2 tau=2"
FLEETS = [
    pytest.param(group, marks=() if group.startswith(FLEET) else pytest.mark.full) for group in GROUPS
]


def answered(name: str, *asked: Any) -> dict[str, harness.Answer]:
    """Answer by the scripts on a relative: the view form, and under ``exact`` the exact one."""
    return scripts.answered_by(Session(SnowflakeDriver(name)), *asked)


@pytest.mark.parametrize("name", RELATIVES)
@pytest.mark.parametrize("group", FLEETS)
def test_cases_by_script(group: str, name: str) -> None:
    asked = [
        replace(case, expected=[one for one in case.expected if one[0] in scripts.RELATIONS])
        for case in GROUPS[group]
    ]
    compare_all(asked, lambda *asked: answered(name, *asked))


@pytest.mark.full
@pytest.mark.parametrize("name", RELATIVES)
@settings(max_examples=max(3, settings().max_examples // 30))
@given(case=cases())
def test_random_sources_give_the_integers_of_the_reference(name: str, case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    found = answered(name, *arguments)
    for question in scripts.RELATIONS:
        expected = harness.by_reference(question, *arguments)
        harness.assert_same(expected, found[question], question)
        if question == "health_indicator":
            harness.assert_same(expected, found["exact"], "exact")


# The state, and runs without Python


def emptied(name: str, tables: StateTables) -> SnowflakeDriver:
    """Return a relative with empty tables of a state, by the script that `gam migrate --sql` prints."""
    driver = SnowflakeDriver(name)
    driver.run(migrations(SNOWFLAKE, tables))
    return driver


@pytest.mark.full
@pytest.mark.migrates
@pytest.mark.parametrize("name", RELATIVES)
def test_the_migrations_can_be_run_twice(name: str) -> None:
    tables = StateTables(prefix=engines.fresh_name("twice"))
    emptied(name, tables)
    driver = emptied(name, tables)
    found = driver.rows(f"SELECT COUNT(*) AS n FROM {SNOWFLAKE.text(tables.table('migration'))}")
    assert found == [{"n": len(files())}]


class Plants:
    """A monitor on DuckDB, which `gam score` runs, and the same on a relative, which its script runs."""

    def __init__(
        self,
        connection: duckdb.DuckDBPyConnection,
        name: str,
        rows: list[Row],
        *method: Any,
        **reach: Any,
    ) -> None:
        self.here, prefix = DuckSession(connection), engines.fresh_name("plants")
        self.table = exp.table_(f"{prefix}telemetry", quoted=True)
        about = {"prefix": prefix, **reach}
        source = gam_db.Source(self.table.name)
        self.scored = Monitor(self.here, source, *method, **about)
        self.driver = emptied(name, self.scored.tables)
        self.there = Session(self.driver)
        for session in (self.here, self.there):
            with session.lent(harness.arrow(rows)) as lent:
                columns = [
                    exp.column(one).as_(one, quoted=True)
                    for one in ("asset", "channel", "time", "value")
                ]
                session.execute(
                    session.engine.create_table(self.table, exp.select(*columns).from_(lent))
                )
        self.scored.migrate()
        self.scored.calibrate()
        for name in TABLES:
            if name != "migration":
                table = self.scored.tables.table(name)
                self.driver.append(table, self.here.fetch(exp.select("*").from_(table)))
        self.run = Monitor(self.there, source, *method, **about)
        self.script = rendered(self.run)

    def arrive(self, rows: list[Row]) -> None:
        """Append rows to both sources."""
        for session in (self.here, self.there):
            if rows:
                scripts.arrive(session, self.table, rows)

    def score(self) -> None:
        """Let both run, and compare all that is stored."""
        self.scored.score()
        self.driver.run(self.script)
        runs.assert_same(runs.stored(self.scored), runs.stored(self.run), "")


def readings(assets: str, start: int, end: int) -> list[Row]:
    """Channels that repeat a pattern, and later on less so."""
    return [
        (*row[:2], (row[2] - runs.BEGIN) // runs.SECOND, row[3])
        for row in runs.readings(assets, start, end)
    ]


#: Batches of three channels: one falls silent and sends again; rows come late, twice, or of a stranger.
COURSE = [
    [],
    readings("abc", 120, 200),
    readings("ab", 200, 260) + runs.doubled(readings("a", 240, 260)),
    readings("ab", 260, 320) + readings("z", 255, 262) + readings("b", 230, 232),
    [],
    readings("abc", 320, 400),
]


@pytest.mark.full
@pytest.mark.parametrize("name", RELATIVES)
def test_a_run_leaves_what_gam_score_leaves(name: str) -> None:
    """Two lists of channels, judged by limits; after each batch all that is stored is the same."""
    alarms = gam_db.Alarms("100 per 1000 judgements")
    with duckdb.connect() as connection:
        plants = Plants(
            connection, name, readings("abc", 0, 120), *runs.MIXED, alarms, lookback=30, park_after=60
        )
        seen: set[str] = set()
        for rows in COURSE:
            plants.arrive(rows)
            plants.score()
            seen |= {table for table, found in runs.stored(plants.run).items() if found}
    assert seen == runs.TABLES.keys() - {"proof"}, "what is due once a day is not due here"


@pytest.mark.full
@pytest.mark.parametrize("name", RELATIVES)
@pytest.mark.parametrize(("kind", "seed"), [("still samples", 0), ("pools", 1), ("pauses", 2)])
def test_a_history_leaves_what_gam_score_leaves(kind: str, seed: int, name: str) -> None:
    told: History = history(kind, seed, 5)
    method = harness.made(told.parameters, told.calibration)
    reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
    with duckdb.connect() as connection:
        plants = Plants(connection, name, told.first, *method, **reach)
        for batch in told.batches:
            plants.arrive(batch.rows)
            plants.score()
        assert runs.stored(plants.run)["bucket"]


@pytest.mark.full
@pytest.mark.parametrize("name", RELATIVES)
def test_a_faster_run_ends_the_script_and_nothing_of_it_counts(name: str) -> None:
    with duckdb.connect() as connection:
        plants = Plants(connection, name, readings("ab", 0, 120), *runs.METHOD)
        plants.arrive(readings("ab", 120, 200))
        plants.score()
        plants.arrive(readings("a", 200, 260))
        run = SNOWFLAKE.text(plants.run.tables.table("run"))
        columns = [
            one for one in plants.driver.describe(plants.run.tables.table("run")) if one != "run_id"
        ]
        others = ", ".join(columns)
        newest = f"WHERE run_id = (SELECT MAX(run_id) FROM {run})"
        faster = f"INSERT INTO {run} (run_id, {others}) SELECT run_id + 1, {others} FROM {run} {newest}"
        before = runs.stored(plants.run)
        begin = "-- Publish"
        assert plants.script.count(begin) == 1
        with pytest.raises(SnowflakeError, match="Another process scored, calibrated or pruned"):
            plants.driver.run(plants.script.replace(begin, f"{faster};\n{begin}"))
        after = runs.stored(plants.run)
        assert len(after["run"]) > len(before["run"]), "those of the faster one are there"
        for table in runs.TABLES.keys() - {"run"}:
            assert after[table] == before[table], table
        plants.driver.run(plants.script)
        assert len(runs.stored(plants.run)["bucket"]) > len(before["bucket"])


# What the relatives are trusted with


def test_a_table_that_is_made_in_a_transaction_is_noticed() -> None:
    """Snowflake commits there; both relatives do not, so the tool refuses it."""
    driver = SnowflakeDriver("fakesnow")
    with pytest.raises(AssertionError, match="CREATE TEMPORARY TABLE a"):
        driver.run("BEGIN;\nCREATE TEMPORARY TABLE a AS SELECT 1 AS b;\nCOMMIT;\n")


@pytest.mark.parametrize(
    "statement",
    [
        "CREATE TEMPORARY TABLE gap_a AS SELECT 1 AS a",
        "CREATE VIEW gap_b COMMENT='said' AS\nSELECT 1 AS a",
        "SELECT DATE_PART(EPOCH_MICROSECOND, SYSDATE()) AS a",
        "SELECT TO_TIMESTAMP_NTZ(1793000000000000, 6) AS a",
        "SELECT 'a_b' LIKE 'a!_b' ESCAPE '!' AS a",
        "DELETE FROM gap_c WHERE (a, b) IN (SELECT a, b FROM gap_c)",
    ],
)
def test_databend_refuses_what_is_taken_out_for_it(statement: str) -> None:
    """So that what a later version has is taken out no longer."""
    databend = relative("databend")
    databend.run("CREATE TABLE IF NOT EXISTS gap_c (a BIGINT, b BIGINT)")
    with pytest.raises(SnowflakeError):
        databend.run(statement, as_it_is=True)
    databend.run(statement.replace("CREATE VIEW", "CREATE OR REPLACE VIEW"))
