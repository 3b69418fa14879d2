"""What a printed script is like: short, in the order of the paper, and read by signal."""

import json
import re
import subprocess
import sys
from pathlib import Path

import duckdb
import pytest
import sqlglot

import gam_db
import scripts
from gam_db.composing.layout import laid_out
from test_views import scanned

SOURCE = gam_db.Source("telemetry", time_kind="timestamp")
PAPER, CALIBRATION = gam_db.Parameters.paper(), gam_db.Calibration(fraction=0.2)

#: Settings that each bring steps of their own.
SETTINGS = {
    "paper": PAPER,
    "robust": gam_db.Parameters(bins=20, window=500),
    "gap": gam_db.Parameters.paper(max_gap="5 min"),
    "still": gam_db.Parameters.paper(still_after=20),
    "sets": gam_db.Parameters.paper(overrides=[gam_db.Override(asset="M1*", bins=20)]),
}


@pytest.mark.parametrize(
    ("engine", "without", "lines", "characters"),
    [
        ("duckdb", None, 400, 14_000),
        ("duckdb", ["certificate"], 200, 7_000),
        ("postgres", None, 440, 15_400),
        ("postgres", ["certificate"], 220, 7_700),
    ],
)
def test_a_script_of_a_plain_table_is_short(
    engine: str, without: list[str] | None, lines: int, characters: int
) -> None:
    script = gam_db.render("view", engine, SOURCE, PAPER, CALIBRATION, without=without)
    assert len(script.splitlines()) <= lines
    assert len(script) <= characters


@pytest.mark.parametrize("settings", SETTINGS)
@pytest.mark.parametrize("engine", ["duckdb", "postgres", "sqlite", "mariadb"])
def test_a_script_keeps_its_lines_and_speaks_of_itself(engine: str, settings: str) -> None:
    script = gam_db.render("view", engine, SOURCE, SETTINGS[settings], CALIBRATION)
    _, _, own = script.partition("\n-- Samples")  # what comes before may be a sentence of an error
    assert max(map(len, own.splitlines())) <= 100
    assert not re.search(r"\b1 = 1\b|\bTRUE\b", script)
    assert "gam-db" not in script.replace("'gam-db: ", "")  # what an error begins with
    assert not re.search(r"^--.*(\bsections? |\.md\b|Python)", script, re.MULTILINE)
    names = re.findall(r"CREATE (?:OR REPLACE )?(?:VIEW|TABLE) (\S+) AS", script)
    assert len(names) == len(set(names)) > 8


def test_the_steps_stand_in_the_order_of_the_paper() -> None:
    script = gam_db.render("view", "duckdb", SOURCE, PAPER, CALIBRATION)
    comments = [line for line in script.splitlines() if line.startswith("-- ")]
    numbers = [re.findall(r"Eq\. (\d)|(Phi)", line) for line in comments]
    order = [number or phi for found in numbers for number, phi in found]
    assert order == ["Phi", "1", "3", "4", "2"]  # the indicator of a window comes last (Eq. 2)
    assert script.count("LAG(code, 1)") == 1
    assert script.count("FLOOR((value - lo)") == 1


def test_the_script_in_the_docs_is_the_one_that_its_command_prints() -> None:
    page = (Path(__file__).parents[2] / "docs" / "script.md").read_text(encoding="utf-8")
    command = re.search(r"```sh\ngam (.*?)\n```", page)
    script = re.search(r"```sql\n(.*?)```", page, re.DOTALL)
    assert command
    assert script
    program = str(Path(sys.executable).with_name("gam"))  # with the settings of a user, not of tests
    printed = subprocess.run([program, *command[1].split()], capture_output=True, text=True, check=True)
    assert script[1] == printed.stdout, "put what the command prints between the marks"


def test_no_alias_stands_before_a_column_in_a_condition_of_the_user() -> None:
    """On ClickHouse an alias goes before a column of the same name, also in the WHERE beside it."""
    source = gam_db.Source("telemetry", where="time > 5", time_kind="counter")
    inner = {
        engine: gam_db.render("exact", engine, source, PAPER, CALIBRATION).partition("time > 5")[0]
        for engine in ("clickhouse", "duckdb")
    }
    assert inner["clickhouse"].rpartition("SELECT")[2].count("AS instant") == 1
    assert inner["duckdb"].rpartition("SELECT")[2].count("AS time") == 1


def test_a_layout_moves_white_space_only() -> None:
    text = gam_db.render("exact", "duckdb", SOURCE, SETTINGS["robust"], CALIBRATION)
    for width in (60, 100, 10_000):
        (tree,) = sqlglot.parse(text, dialect="duckdb")
        assert tree is not None
        plain = tree.sql(dialect="duckdb", comments=False)
        assert "".join(laid_out(plain, "duckdb", width).split()) == "".join(plain.split())


SMALL = gam_db.Parameters(m=2, bins=4, window=20, range="min_max")


def test_a_filter_on_one_signal_reads_its_rows_alone() -> None:
    session, table, view = scripts.filtered("duckdb")
    (plan,) = session.driver.fetch(f"EXPLAIN (ANALYZE, FORMAT JSON) {view}").to_pylist()
    read = list(scanned(json.loads(plan["explain_value"])["operator"], table))
    assert read
    assert set(read) == {600}  # of 24,000


def test_readers_keep_the_old_view_while_a_script_builds_the_new_one() -> None:
    first = gam_db.render("view", "duckdb", gam_db.Source("telemetry"), SMALL, prefix="p_")
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT 'a' AS asset, 'c' AS channel, i AS time, "
            "i % 5 + 0.5 AS value FROM range(200) t(i)"
        )
        connection.execute(first)
        reader = connection.cursor()
        *built, commit = scripts.END.split(first.removesuffix(";\n"))
        assert commit.strip() == "COMMIT"
        for statement in built:
            connection.execute(statement)
        assert reader.sql("SELECT count(*) FROM p_health").fetchall() == [(160,)]
        connection.execute(commit)
        assert reader.sql("SELECT count(*) FROM p_health").fetchall() == [(160,)]


@pytest.mark.parametrize("gap", [None, 3])
def test_a_printed_probe_is_that_of_python(gap: int | None) -> None:
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT 'M' || k % 2 AS asset, 'j' || k AS channel, i AS time, "
            "sin(i / (5.0 + k)) + hash(i * 31 + k) % 1000 / 3000.0 AS value "
            "FROM range(3000) t(i), range(3) s(k) WHERE i % 97 > k"
        )
        source = gam_db.Source("telemetry", time_kind="counter")
        method = (
            gam_db.Parameters(m=2, tau=2, bins=12, window=60, max_gap=gap),
            gam_db.Calibration(fraction=0.5),
        )
        connection.execute(gam_db.render("view", "duckdb", source, *method, without=()))
        for relation, of in (("probes", gam_db.probe), ("support_summary", gam_db.support)):
            expected = of(source, *method, engine=connection)
            printed = connection.table(f"gam_live_{relation}")
            names = [name for name in printed.columns if name in expected.column_names]
            assert {"novel", "vectors"} <= {*names} or {"sees", "sees_frozen", "verdict"} <= {*names}
            rows = printed.select(*map(duckdb.ColumnExpression, names)).to_arrow_table()
            order = [(name, "ascending") for name in names[:4]]
            assert rows.sort_by(order).to_pylist() == expected.select(names).sort_by(order).to_pylist()
