"""Engines under test: which are asked for, and an open session on each.

``pytest --engines fast`` (the default) runs on DuckDB and SQLite, ``all`` on every engine that is called
executed, on the stand-ins for others, and dbt; ``NAME,...`` runs on those named. One that is asked for
and cannot be started is a failure.
"""

import atexit
import importlib
import itertools
import os
import shutil
import sqlite3
import tempfile
from collections.abc import Callable

import duckdb
import pytest
import sqlglot
from hypothesis import settings

import mariadb_server
import postgres_server
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from spark_settings import QUICK_JAVA, QUICK_SPARK

FAST = ("duckdb", "sqlite")

#: Names another way to Spark than a session in this process: ``connect``, by a Spark Connect server.
WAY = "GAM_SPARK"


def spark() -> Session:
    """Open Spark in this process, small and quick to start; its tables go with the process.

    With ``GAM_SPARK=connect`` that is on a Spark Connect server, which is another process.
    """
    if os.environ.get(WAY) == "connect":
        return connect(importlib.import_module("connect_server").server())
    settings = " ".join(f"--conf {name}={value}" for name, value in QUICK_SPARK.items())
    os.environ.setdefault("PYSPARK_SUBMIT_ARGS", f"{settings} pyspark-shell")
    os.environ.setdefault("SPARK_MASTER", "local[2]")
    os.environ.setdefault("SPARK_DRIVER_MEMORY", "1g")
    os.environ.setdefault("JDK_JAVA_OPTIONS", QUICK_JAVA)
    folder = tempfile.mkdtemp(prefix="gam-tests-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return connect(f"spark://{folder}")


#: engine -> what opens a session on it, once in every process of the tests
OPENERS: dict[str, Callable[[], Session]] = {
    "duckdb": lambda: connect(),
    "sqlite": lambda: connect("sqlite://"),
    "postgres": lambda: connect(postgres_server.server().url),
    "mariadb": lambda: connect(mariadb_server.server()),
    "clickhouse": lambda: connect("chdb://"),
    "spark": spark,
}

#: engine -> the version that the tests see
VERSIONS: dict[str, Callable[[], str]] = {
    "duckdb": lambda: duckdb.__version__,
    "sqlite": lambda: sqlite3.sqlite_version,
    "postgres": postgres_server.version,
    "mariadb": mariadb_server.version,
    "clickhouse": lambda: clickhouse_version(),
    "spark": lambda: importlib.import_module("pyspark").__version__,
}

#: engine -> random cases of the agreement tests, about as many as take the same time on each
EXAMPLES = {"duckdb": 16, "sqlite": 12, "postgres": 6, "mariadb": 4, "clickhouse": 3, "spark": 1}


def examples(name: str) -> int:
    """Return how many random cases an engine is given; HYPOTHESIS_PROFILE=many gives more of them."""
    return max(EXAMPLES[name] * settings().max_examples // 100, 1)


#: Where all engines are asked for, those that take seconds for a statement leave these out; asked for by
#: name, they run all. (To Spark one case of the specification is as dear as thirty of one setting.)
OMITTED = {
    "test_cases": ("spark-1 case", "spark-2 cases", "spark-3 cases"),
    "test_cases_by_script": (
        "spark",
        "clickhouse-1 case",
        "mariadb-1 case",
        "clickhouse-2 cases",
        "clickhouse-3 cases",
        "clickhouse-4 cases",
    ),
    "test_scripts_equal_the_reference": ("spark",),
    "test_bins_are_frozen_and_no_other_setting": ("spark", "clickhouse"),
    "test_every_channel_has_the_finest_grid_that_it_fills": ("spark", "clickhouse"),
    "test_alarms_that_grow_are_those_of_all_at_once": ("spark", "mariadb"),
    "test_a_signal_that_stands_still_is_standing": ("spark", "mariadb", "clickhouse"),
    "test_cells_are_those_of_the_support_and_of_quarantine_in_units": ("spark", "clickhouse"),
    "test_the_ladder_is_the_floor_on_each_grid": ("spark", "clickhouse"),
    "test_any_history_ends_in_the_tables_of_one_full_run": ("spark",),
    "test_all_that_is_shown_is_what_duckdb_shows": ("spark",),
    "test_reference_counts_on_spark": ("1/", "3/5/", "3/1/20"),
    "test_a_repair_inside_a_run_is_not_lost": ("spark", "mariadb", "clickhouse"),
    "test_no_repair_inside_a_run_is_lost": ("spark",),
    "test_versions_and_pruning_beside_a_repair": ("spark", "mariadb", "clickhouse"),
    "test_two_monitors_of_one_name_give_no_key_twice": ("spark", "mariadb"),
    "test_asking_again_composes_nothing": ("spark", "mariadb", "clickhouse"),
    "test_the_census_gives_the_integers_of_the_reference": (
        *(f"spark-{first}" for first in "adklost"),
        "clickhouse-o",
        "clickhouse-s",
        "mariadb-o",
        "mariadb-a",
        "mariadb-s",
    ),
    "test_what_is_interrupted_is_as_in_the_reference_on_trust": (
        *(
            f"spark-{first}"
            for first in ("as", "longer", "one", "delays", "still", "sets of which one has")
        ),
        *(f"{engine}-still," for engine in ("mariadb", "clickhouse")),
    ),
    "test_single_vectors_have_the_same_proof": (
        *("spark-none", "spark-one", "spark-the first-two"),
        *(f"{engine}-{again}" for engine in ("mariadb", "clickhouse") for again in ("none", "one")),
    ),
    "test_one_row_of_long_ago": ("spark", "mariadb", "clickhouse"),
    "test_a_channel_without_calibration_has_no_vector_as_proof": ("spark", "mariadb", "clickhouse"),
    "test_many_columns_are_read_as_few_are": ("clickhouse", "postgres-None"),
    "test_an_instant_that_occurs_twice_is_found": ("spark",),
    "test_health_alone_has_the_same_proof": ("spark-the", "spark-one"),
    "test_growth_counts_cells_as_they_come": ("spark",),
    "test_any_mix_ends_in_the_tables_of_one_full_run": ("spark",),
    "test_however_rows_lie_the_body_of_the_engine_serves": ("spark", "clickhouse"),
    "test_what_the_body_of_the_engine_keeps": ("spark", "clickhouse"),
    "test_numbers_are_as_wide_as_they_may_be": ("spark-shuffled",),
    "test_each_body_finds_what_occurs_twice": ("spark", "clickhouse"),
    "test_what_has_no_room_is_not_held": ("spark",),
    "test_the_steps_run_once_more": (
        *(
            "spark-in",
            "spark-beside",
            "spark-with",
            "spark-one",
            "spark-large",
            "spark-none",
            "spark-of",
        ),
    ),
    "test_however_rows_lie": ("spark", "clickhouse"),
    "test_what_else_is_asked_for_is_answered": ("spark", "clickhouse", "mariadb", "postgres"),
    "test_what_is_not_scored_is_proven_as_well": ("spark", "clickhouse", "mariadb"),
    "test_the_onset_is_the_first_bucket_of_the_run_that_lasts": ("spark", "clickhouse", "mariadb"),
    "test_what_is_in_the_file_is_what_the_tables_say": ("spark", "clickhouse"),
    "test_the_same_tables_make_the_same_bytes_on_every_engine": ("spark",),
    "test_limits_judgements_and_episodes_equal_the_reference": ("spark",),
    "test_a_soak_ends_in_the_tables_of_one_full_run": ("spark", "clickhouse", "mariadb"),
    "test_figures_are_those_of_the_tables": ("spark", "clickhouse", "mariadb"),
    "test_every_form_says_the_same_of_every_channel": ("spark", "mariadb"),
    "test_figures_of_check_are_those_of_numpy": ("spark",),
    "test_a_support_too_large_for_a_set_is_joined": ("spark",),
    "test_rows_that_belong_nowhere_count_nowhere": ("spark",),
    "test_a_parked_channel_is_read_after_the_clock_stood_ahead": ("spark", "mariadb", "clickhouse"),
    "test_calibration_is_counted_after_the_clock_stood_ahead": ("spark", "mariadb", "clickhouse"),
    "test_a_replay_of_calibration_is_no_change": ("spark", "mariadb", "clickhouse"),
    "test_rows_that_belong_nowhere_stay_known": ("spark", "mariadb", "clickhouse"),
    "test_it_ends_in_the_tables_of_a_counter": ("spark",),
    "test_random_cases_give_the_integers_of_a_counter": ("spark",),
    "test_it_gives_the_integers_of_a_counter": ("spark-across",),
}

#: What else can be asked for: engines that are run on a stand-in, and the tools beside them.
STAND_INS = ("bigquery", "snowflake", "relatives", "dbt")

#: Engines whose databases lie in memory. Each test has one of its own, in which names begin anew: so the
#: texts of its statements are those of other tests, which were written and parsed already, and what
#: migrating makes is copied (begun.py). And SQLite reads all views again whenever a table is made or
#: changed: migrating takes 0.15 s in an empty database, and 1.3 s beside forty states.
IN_MEMORY = ("duckdb", "sqlite")

_numbers = itertools.count()
_names = _numbers


def asked_for(asked: str) -> tuple[str, ...]:
    """Return all that an option of the command line asks for."""
    known = (*OPENERS, *STAND_INS)
    names = {"fast": FAST, "all": known}.get(asked, tuple(asked.split(",")))
    for name in names:
        if name not in known:
            raise pytest.UsageError(f"--engines: there is no {name!r}; fast, all or {', '.join(known)}")
    return names


def chosen(asked: str) -> list[str]:
    """Return the engines among them on which a session is opened."""
    return [name for name in asked_for(asked) if name in OPENERS]


def is_left_out(file: str, asked: str) -> bool:
    """Tell whether a file, ``test_NAME.py`` or ``test_NAME_....py``, is of a NAME not asked for."""
    names = [name for name in (*OPENERS, *STAND_INS) if f"{file[:-3]}_".startswith(f"test_{name}_")]
    return bool(names) and names[0] not in asked_for(asked)


def shortened(tests: list[pytest.Item], asked: str, is_whole: bool) -> list[pytest.Item]:
    """Return the tests without those that would take too long together, those on Spark first.

    So one process of the tests runs them all, and Java is started, and gets warm, but once.

    Args:
        tests: that were found.
        asked: the option of the command line.
        is_whole: whether nothing was chosen but engines: a plain run leaves thorough tests out.
    """
    if asked == "fast" and is_whole:
        return [test for test in tests if test.get_closest_marker("thorough") is None]
    if asked != "all":
        return tests
    named = [(test, *test.name.partition("[")[::2]) for test in tests]
    kept = [test for test, name, case in named if not case.startswith(OMITTED.get(name, ()))]
    return sorted(kept, key=lambda test: "spark" not in test.nodeid)


_sessions: dict[str, Session] = {}


def session(name: str) -> Session:
    """Return the session on an engine; one that is not in memory stays for other tests."""
    if name not in _sessions:
        _sessions[name] = OPENERS[name]()
    return _sessions[name]


def begin(engine: str | None = None) -> None:
    """Begin a test, or a case of one, that needs nothing of what others left behind.

    Args:
        engine: that the test runs on, None where it names none.
    """
    global _names
    for name in IN_MEMORY:
        if (held := _sessions.pop(name, None)) is not None:
            held.close()
    _names = itertools.count() if engine in IN_MEMORY else _numbers


def clickhouse_version() -> str:
    """Return the version of ClickHouse inside this process."""
    found = session("clickhouse").fetch(sqlglot.parse_one("SELECT VERSION() AS version"))
    return str(found["version"][0].as_py())


def fresh_name(stem: str) -> str:
    """Return the name of a table or a prefix that nothing has in the database of the test's engine."""
    return f"{stem}{next(_names)}_"
