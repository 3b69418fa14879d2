"""``gam export dbt``: what is written is a dbt package, and it builds the numbers of gam score."""

import random
from pathlib import Path
from typing import Any

import duckdb
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner, Result

import comparisons
import frozen
import gam_db
import harness
from batches import KINDS, history
from dbt_builder import Builder
from gam_db.cli import app
from gam_db.engines.postgres import PATH
from gam_db.export import Package, write
from gam_db.export.models import ADAPTERS
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import StateTables

EXAMPLES = 2
#: What the tables of a state beside the package are called.
STATE = StateTables(prefix="state_").shown
BUCKETS = """
    SELECT asset, channel, bucket_no AS bucket, first_time, last_time, context_time, samples, novel,
        out_of_range, novel_in_window
    FROM gam_bucket JOIN gam_channel USING (channel_id)
    ORDER BY asset, channel, bucket_no
"""


def package(**changes: Any) -> Package:
    """A small package over a table that counts time."""
    said: dict[str, Any] = {
        "source": gam_db.Source("telemetry", time_kind="counter"),
        "parameters": gam_db.Parameters(m=2, tau=1, bins=4, window=4, stride=2),
        "calibration": gam_db.Calibration(intervals=[(0, 20)]),
        **changes,
    }
    return Package(**said)


def arrive(connection: duckdb.DuckDBPyConnection, rows: list[Any]) -> None:
    connection.register("arriving_rows", harness.arrow(rows))
    connection.execute("INSERT INTO telemetry SELECT * FROM arriving_rows")
    connection.unregister("arriving_rows")


def opened() -> duckdb.DuckDBPyConnection:
    connection = duckdb.connect()
    connection.execute(
        "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
    )
    return connection


# What it builds


def fixed(kind: str, chance: random.Random) -> dict[str, Any]:
    """A calibration that every build resolves alike, and that ends before anything comes late."""
    end = chance.choice([12, 20])
    said: dict[str, Any] = {"intervals": [(-9, end)]}
    if kind == "given start":
        said = {"intervals": [(-9, 5), (8, end)], "score_from": chance.choice([None, 5, 18, 33])}
    if kind == "pools":
        said |= {"pool": "channel", "overrides": {"m_1*": None, "m_2*": {"intervals": [(0, 15)]}}}
    return said


@pytest.mark.thorough
@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=max(EXAMPLES, settings().max_examples // 25))
@given(seed=st.integers(0, 2**32))
def test_any_history_of_builds_equals_a_full_refresh(kind: str, seed: int) -> None:
    """Thirty channels a history: late and repeated rows, pauses, damage; at the end the reference."""
    told = history(kind, seed)
    calibration = fixed(kind, random.Random(seed))
    parameters, rule = harness.made({**told.parameters, "overrides": []}, calibration)
    made = package(parameters=parameters, calibration=rule, lookback=told.lookback)
    with opened() as connection:
        builder = Builder(made.files(), connection)
        arrive(connection, told.first)
        builder.build()
        for batch in told.batches:
            arrive(connection, batch.rows)
            if batch.runs:
                builder.build()
        found = builder.rows(BUCKETS)
        harness.assert_same(frozen.buckets(told.first, told.final, parameters, rule), found, "buckets")
        comparisons.compared("duckdb", "dbt", told.final, parameters, rule, told.first)
        builder.build(full_refresh=True)
        harness.assert_same(builder.rows(BUCKETS), found, "a full refresh")


def ran(rows: list[Any]) -> list[Any]:
    """Rows with what the machine ran: shifts of seven; new from 40 on, and nothing from 55 on."""

    def program(time: int) -> str | None:
        return None if time >= 55 else "new" if 40 <= time < 47 else "ab"[time // 7 % 2]

    return [(*row, program(row[2])) for row in rows]


@pytest.mark.parametrize("kind", KINDS)
def test_builds_with_programs_equal_the_reference(kind: str) -> None:
    drawn = history(kind, 53, 12)
    limits = {"bins": 4, "least_vectors": 2, "target_floor": 0.7, "overrides": []}
    calibration = fixed(kind, random.Random(53))
    parameters, rule = harness.made({**drawn.parameters, **limits}, calibration)
    source = gam_db.Source("telemetry", program="program", time_kind="counter")
    files = package(
        source=source, parameters=parameters, calibration=rule, lookback=drawn.lookback
    ).files()
    with opened() as connection:
        connection.execute("ALTER TABLE telemetry ADD COLUMN program VARCHAR")
        builder = Builder(files, connection)
        arrive(connection, ran(drawn.first))
        builder.build()
        for batch in drawn.batches:
            if batch.rows:
                arrive(connection, ran(batch.rows))
            builder.build()
        found = builder.rows(BUCKETS)
        expected = frozen.buckets(ran(drawn.first), ran(drawn.final), parameters, rule)
        harness.assert_same(expected, found, "buckets")
        assert builder.rows("SELECT 1 FROM gam_program WHERE verdict = 'ready'")
        builder.build(full_refresh=True)
        harness.assert_same(builder.rows(BUCKETS), found, "a full refresh")


#: Columns that are the stored form's alone: versions, monitors and runs.
ONLY_STORED = {
    *("monitor", "version_no", "version_id", "m", "tau", "bins", "stride", "target_floor"),
    *("settings_hash", "method_hash", "data_time", "data_tick", "looked_at", "differing_contexts"),
    *("repair_from_time", "repair_from_tick", "calibration_readings", "calibration_readings_now"),
    *("at_least", "silent_for", "episode_id", "asking", "window_from_tick", "label"),
}


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("calibration", "gap"),
    [
        ({"intervals": [(-9, 14)]}, None),
        ({"intervals": [(-9, 5), (8, 14)], "exclude": [(2, 3)], "score_from": 17}, 2),
        ({"intervals": [(-9, 14)], "pool": "channel", "overrides": {"m_1*": None}}, None),
    ],
)
def test_tables_are_those_of_the_stored_form(calibration: dict[str, Any], gap: int | None) -> None:
    told = history("short form", 1)
    parameters, rule = harness.made(
        {"m": 2, "tau": 2, "bins": 4, "window": 4, "stride": 2, "max_gap": gap}, calibration
    )
    with opened() as connection:
        arrive(connection, told.final)
        monitor = Monitor(
            connection, gam_db.Source("telemetry"), parameters, rule, prefix="state_", park_after=False
        )
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        builder = Builder(package(parameters=parameters, calibration=rule).files(), connection)
        builder.build()
        for model in builder.built:
            name = model.removeprefix("gam_")
            columns = connection.sql(f"SELECT * FROM {model} LIMIT 0").columns
            stored = connection.sql(f"SELECT * FROM {STATE(name)} LIMIT 0").columns
            if name in ("health", "fleet"):
                pooled = set() if rule.pool else {"vouched_by", "taught_by", "member_floor", "vouching"}
                assert set(stored) - ONLY_STORED - pooled == set(columns) | set(_dates(name))
            judged = JUDGED if name in ("fleet", "machine") else set()
            shared = [f'"{column}"' for column in columns if column in stored and column not in judged]
            of_both = [
                named(builder.rows(f"SELECT {', '.join(shared)} FROM {table}"), *known)
                for table, known in (
                    (model, (builder.rows("SELECT * FROM gam_channel"),)),
                    (STATE(name), (builder.rows(STORED_CHANNELS),)),
                )
            ]
            assert of_both[0] == of_both[1], model
            assert of_both[0]


#: When each signal of two machines leaves health, and when it comes back.
LEAVING = {
    ("A", "x"): (400, 900),
    ("A", "y"): (420, 900),
    ("A", "z"): (700, 900),
    ("A", "calm"): (900, 900),
}
LEAVING |= {("B", "x"): (300, 500), ("B", "y"): (410, 900)}


def test_onsets_and_machines_are_those_of_the_indicator() -> None:
    """A walk over the buckets; a monitor has episodes instead, which windows of their own open."""
    rows = [
        (*key, t, float(t % 5) + (9.0 if left <= t < back else 0.0))
        for key, (left, back) in LEAVING.items()
        for t in range(900)
    ]
    parameters, rule = harness.made(
        {"m": 2, "tau": 1, "bins": 5, "window": 60, "stride": 10}, {"intervals": [(0, 249)]}
    )
    since: dict[tuple[str, str], int | None] = {}
    with opened() as connection:
        arrive(connection, rows)
        builder = Builder(package(parameters=parameters, calibration=rule).files(), connection)
        builder.build()
        for row in builder.rows("SELECT * FROM gam_health ORDER BY asset, channel, bucket"):
            name = (row["asset"], row["channel"])
            is_above = row["hi"] is not None and row["hi"] > row["hi_limit"]
            since[name] = (since.get(name) or row["last_tick"]) if is_above else None
        fleet = builder.rows("SELECT * FROM gam_fleet")
        machines = builder.rows("SELECT * FROM gam_machine ORDER BY machine_rank")
    assert {(row["asset"], row["channel"]): row["since_tick"] for row in fleet} == since
    assert {name for name, tick in since.items() if tick is not None} == {
        *(("A", "x"), ("A", "y"), ("A", "z"), ("B", "y"))
    }
    assert all((row["status"] == "high") == (row["since_tick"] is not None) for row in fleet)
    told = ("asset", "signals", "watched", "above", "not_judged", "first_channel", "together")
    assert [tuple(row[name] for name in told) for row in machines] == [
        ("A", 4, 4, 3, 0, "x", 2),
        ("B", 2, 2, 1, 0, "y", 1),
    ]
    assert machines[0]["since_tick"] == since["A", "x"]


#: What a monitor judges by episodes, also where its indicator opens them, and a package by buckets.
JUDGED = {
    *("status", "urgency", "needs_attention", "is_above", "strength", "since_tick", "above"),
    *("judged", "not_judged", "first_channel", "strongest_channel", "machine_rank", "together"),
}


STORED_CHANNELS = f"SELECT * FROM {STATE('channel')} JOIN {STATE('version')} USING (channel_id)"


def named(rows: list[dict[str, Any]], channels: list[dict[str, Any]]) -> list[str]:
    """Rows with names in the place of numbers, in some order: the two number channels differently."""
    names = {row["channel_id"]: (row["asset"], row["channel"]) for row in channels}
    pools: dict[int, list[Any]] = {}
    for row in sorted(channels, key=lambda row: (row["asset"], row["channel"])):
        pools.setdefault(row["support_id"], []).append((row["asset"], row["channel"]))
    for row in rows:
        if "channel_id" in row:
            row["channel_id"] = names[row["channel_id"]]
        if "support_id" in row:
            row["support_id"] = pools[row["support_id"]]
    return sorted(map(repr, rows))


def _dates(view: str) -> list[str]:
    """Columns that a source which counts time does not fill."""
    return ["last_time", "since_time"] if view == "fleet" else ["first_time", "last_time"]


def test_late_rows_without_a_value_end_buckets() -> None:
    rows: list[Any] = [("a", "x", 2 * time, float(time % 3)) for time in range(40)]
    late: list[Any] = [("a", "x", time, None) for time in (71, 73, 75, 77)]
    with opened() as connection:
        builder = Builder(package(lookback=12).files(), connection)
        arrive(connection, rows)
        builder.build()
        before = builder.rows(BUCKETS)
        arrive(connection, late)
        builder.build()
        after = builder.rows(BUCKETS)
        assert len(after) == len(before) - 2
        assert builder.rows("SELECT * FROM gam_bucket WHERE last_time IS NULL") == []
        builder.build(full_refresh=True)
        assert builder.rows(BUCKETS) == after


def test_what_was_learnt_stays_until_a_full_refresh() -> None:
    rows: list[Any] = [("a", "x", time, float(time % 3)) for time in range(40)]
    with opened() as connection:
        builder = Builder(package().files(), connection)
        arrive(connection, rows)
        builder.build()
        changed, unknown = (
            builder.rendered("", check(package().files(), name), is_later=False)
            for name in ("calibration_is_unchanged", "channels_are_known")
        )
        assert builder.rows(changed) == builder.rows(unknown) == []
        learnt = builder.rows("SELECT * FROM gam_support ORDER BY ALL")
        arrive(connection, [("a", "x", 15, 0.5), ("b", "x", 3, 1.0)])
        builder.build()
        assert builder.rows("SELECT * FROM gam_support ORDER BY ALL") == learnt
        (found,) = builder.rows(changed)
        assert (found["calibration_readings"], found["calibration_readings_now"]) == (21, 22)
        assert builder.rows(unknown) == [{"asset": "b", "channel": "x", "readings": 1}]
        builder.build(full_refresh=True)
        assert builder.rows(changed) == builder.rows(unknown) == []
        assert [row["asset"] for row in builder.rows("SELECT asset FROM gam_channel ORDER BY 1")] == [
            *("a", "b"),
        ]


def check(files: dict[str, str], name: str) -> str:
    """A test of the package, which is a query whose rows are warned of."""
    text = files[f"tests/gam_{name}.sql"]
    assert text.startswith("{{ config(severity='warn') }}")
    return text


# What is written


def test_names_are_looked_up_in_a_package_as_everywhere() -> None:
    postgres = ADAPTERS["postgres"]
    assert postgres["before"] == f"SET LOCAL search_path TO {PATH}"
    assert postgres["before"] in postgres["config"]["pre_hook"]


@pytest.mark.parametrize("engine", ADAPTERS)
def test_a_package_holds_what_dbt_reads(engine: str) -> None:
    wide = gam_db.WideSource("plant.lines.readings", ("v", "w"), None, "at", time_kind="timestamp")
    days = gam_db.Calibration(intervals=[("2026-01-01", "2026-01-08")])
    files = package(engine=engine, source=wide, calibration=days).files()
    read = {path: yaml.safe_load(text) for path, text in files.items() if path.endswith(".yml")}
    (source,) = read["models/sources.yml"]["sources"]
    (table,) = source["tables"]
    assert (source["database"], source["schema"], table["identifier"]) == ("plant", "lines", "readings")
    assert [column["name"] for column in table["columns"]] == ["at", "v", "w"]
    assert table["config"]["freshness"] == {"warn_after": {"count": 24, "period": "hour"}}
    described = {
        model["name"]: model
        for path, document in read.items()
        for model in document.get("models", [])
        if isinstance(model, dict)
    }
    models = {
        path.rpartition("/")[2].removesuffix(".sql"): text
        for path, text in files.items()
        if path.startswith("models/") and path.endswith(".sql")
    }
    assert set(described) == set(models)
    for name, model in described.items():
        assert model["description"].endswith((".", "?"))
        kind = Builder.config(models[name])["materialized"]
        assert ("columns" in model) == (kind != "ephemeral")
        if kind == "ephemeral":
            continue
        assert kind in ("incremental", "view")
        assert all(len(column["description"]) > 3 for column in model["columns"])
        assert any("not_null" in column.get("data_tests", []) for column in model["columns"])
    bounds = {column["name"]: column for column in described["gam_bounds"]["columns"]}
    (tested,) = [test for test in bounds["verdict"]["data_tests"] if isinstance(test, dict)]
    assert "too_fine" in tested["accepted_values"]["arguments"]["values"]
    assert "{% test gam_unique_combination(model, columns) %}" in "".join(files.values())


#: A package as in the paper, and one with all that is default, of a plain table.
PLAIN = {
    "paper": gam_db.Parameters.paper(),
    "default": gam_db.Parameters(m=3, tau=1, bins=20, window=1000),
}


@pytest.mark.parametrize(
    ("settings", "engine"), [("default", "duckdb"), *(("paper", engine) for engine in ADAPTERS)]
)
def test_models_are_short(settings: str, engine: str) -> None:
    source = gam_db.Source("telemetry", time_kind="timestamp")
    healthy = gam_db.Calibration(intervals=[("2026-01-01", "2026-01-31")])
    made = package(source=source, parameters=PLAIN[settings], calibration=healthy, engine=engine).files()
    models = {path: text.splitlines() for path, text in made.items() if path.endswith(".sql")}
    assert {path.split("/")[1] for path in models if path.startswith("models/")} == {
        *("staging", "intermediate", "mart")
    }
    assert max(len(lines) for lines in models.values()) <= 120
    assert max(len(line) for lines in models.values() for line in lines) <= 100
    if settings == "paper" and engine in ("duckdb", "postgres"):
        assert sum(len(lines) for lines in models.values()) <= 1200


def test_a_package_has_no_columns_for_what_it_leaves_out() -> None:
    whole, short = (package(without=without).files() for without in ((), ("curve", "probe")))
    assert "models/intermediate/gam_probe.sql" in whole.keys() - short.keys()
    for column in ("vectors_needed", "sees_frozen", "blind_reason"):
        assert any(column in text for path, text in whole.items() if path.startswith("models/"))
        assert not any(column in text for path, text in short.items() if path.startswith("models/"))


def test_settings_of_another_package_are_told_apart() -> None:
    """The test of settings_hash stops a build before anything is scored under a mix."""
    hashes = [
        [line for line in made.files()["models/staging/schema.yml"].splitlines() if "values: [" in line]
        for made in (
            package(),
            package(lookback=5, prefix="gam2_"),
            package(parameters=gam_db.Parameters(m=2, bins=5, window=4, stride=2)),
            package(source=gam_db.Source("telemetry", where="value > 1", time_kind="counter")),
        )
    ]
    assert hashes[0] == hashes[1]
    assert hashes[0][0] != hashes[2][0]
    assert hashes[0][0] != hashes[3][0]


@pytest.mark.parametrize(
    ("part", "changes"),
    [
        ("closed intervals", {"calibration": gam_db.Calibration(fraction=0.5)}),
        ("closed intervals", {"calibration": gam_db.Calibration(duration=5)}),
        ("at least one", {"calibration": gam_db.Calibration(intervals=[(1, 2)], exclude=[(0, 9)])}),
        (
            "one set of parameters",
            {"parameters": gam_db.Parameters(overrides=[gam_db.Override(asset="a", m=2)])},
        ),
        ("a table of the warehouse", {"source": gam_db.Source("readings.parquet")}),
        ("needs the names of its channels", {"source": gam_db.WideSource("readings")}),
        ("'{{ x }}'", {"source": gam_db.Source("t", where="asset = '{{ x }}'")}),
        ("'{% if'", {"source": gam_db.Source("t", value="{% if")}),
        ("no adapter for sqlite", {"engine": "sqlite"}),
        ("'postgres'", {"engine": "postgre"}),
        ("prefix", {"prefix": "1 "}),
        ("schema is 'lines'", {"source": gam_db.Source("plant.t"), "schema": "lines"}),
        ("lookback", {"lookback": "1 parsec"}),
        ("certificate", {"without": ["certificate"]}),
        ("'prob'", {"without": ["prob"]}),
    ],
)
def test_what_cannot_be_a_package_is_refused(part: str, changes: dict[str, Any], tmp_path: Path) -> None:
    with pytest.raises(gam_db.errors.UserError) as told:
        write(package(**changes), tmp_path / "package")
    assert part in str(told.value)
    assert not (tmp_path / "package").exists()


@pytest.mark.parametrize("engine", ADAPTERS)
def test_a_profile_to_fill_in_is_that_of_the_project_and_holds_no_password(
    engine: str,
) -> None:
    files = package(engine=engine, prefix="other_").files()
    said = yaml.safe_load(files["profiles.example.yml"])[
        yaml.safe_load(files["dbt_project.yml"])["profile"]
    ]
    target = said["outputs"][said["target"]]
    assert target["type"] == ADAPTERS[engine]["package"].removeprefix("dbt-")
    assert all("env_var(" in target[secret] for secret in ("password", "token") if secret in target)


def test_a_folder_of_something_else_is_left_alone(tmp_path: Path) -> None:
    write(package(), tmp_path)
    (tmp_path / "profiles.yml").write_text("theirs")
    files = write(package(lookback=7), tmp_path)
    assert all(path.is_file() for path in files)
    assert (tmp_path / "profiles.yml").read_text() == "theirs"
    for prefix, text in (("other_", None), ("gam_", "name: theirs\n")):
        if text is not None:
            (tmp_path / "dbt_project.yml").write_text(text)
        before = sorted(tmp_path.rglob("*"))
        with pytest.raises(gam_db.errors.ConfigurationError, match="something other"):
            write(package(prefix=prefix), tmp_path)
        assert sorted(tmp_path.rglob("*")) == before


def invoke(*words: str) -> Result:
    return CliRunner().invoke(app, ["export", "dbt", *words])


def test_the_command_writes_a_package_for_a_table_it_can_see(tmp_path: Path) -> None:
    database, folder = tmp_path / "plant.duckdb", tmp_path / "package"
    with duckdb.connect(str(database)) as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT 'r1' AS robot, 'j1' AS joint, "
            "TIMESTAMP '2026-01-01' + INTERVAL (i) SECOND AS ts, sin(i) AS torque FROM range(400) t(i)"
        )
    made = invoke(
        *(str(folder), "telemetry", "--database", str(database), "--window", "50"),
        *("--calibrate", "2026-01-01/2026-01-01T00:01:30", "--lookback", "5 min"),
    )
    assert made.exit_code == 0, made.stderr
    assert "dbt build" in made.stdout
    files = {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*.*")}
    with duckdb.connect(str(database)) as connection:
        builder = Builder(dict(sorted(files.items())), connection)
        builder.build()
        (found,) = builder.rows(
            "SELECT asset, channel, count(*) AS n, max(last_time) AS t FROM gam_health GROUP BY ALL"
        )
    assert (found["asset"], found["channel"], found["n"]) == ("r1", "j1", 6)
    assert str(found["t"]) == "2026-01-01 00:06:30"


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ("Name a SOURCE", []),
        ("closed intervals", ["t", "--time-kind", "counter"]),
        ("'postgres'", ["t", "--calibrate", "0/5", "--engine", "postgre"]),
    ],
)
def test_errors_are_one_paragraph(
    part: str, words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    found = invoke("package", *words)
    assert found.exit_code == 1
    assert part in " ".join(found.stderr.split())
    assert "Traceback" not in found.stderr
    assert not (tmp_path / "package").exists()
