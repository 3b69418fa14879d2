"""What is said of the engines is what the tests run: no more, and in the same versions."""

import csv
import datetime as dt
import importlib
from pathlib import Path
from types import SimpleNamespace

import duckdb
import pyarrow as pa
import pytest
import sqlglot
from sqlglot import exp

import engine_page
import engines
import sets
from evidence import version_of
from gam_db import data
from gam_db.composing import template
from gam_db.engines import EVIDENCE, NAMES, engine_named
from gam_db.engines.refusals import refusal
from gam_db.errors import StatementError, UserError

ROOT = Path(__file__).parents[2]


def test_every_engine_has_its_row() -> None:
    made = [one for one in (ROOT / "gam_db" / "engines").glob("[a-z]*") if one.suffix in ("", ".py")]
    modules = (importlib.import_module(f"gam_db.engines.{path.stem}") for path in made)
    engines_of = [module.ENGINE for module in modules if hasattr(module, "ENGINE")]
    assert {engine.name for engine in engines_of} == set(NAMES)
    for row in EVIDENCE.values():
        assert row.evidence in engine_page.CLASSES
        assert (ROOT / row.tests).is_file()
        assert dt.date(2026, 11, 1) <= dt.date.fromisoformat(row.date) <= dt.date.today()


@pytest.mark.parametrize("name", NAMES)
def test_the_version_is_the_one_that_the_tests_run(name: str, request: pytest.FixtureRequest) -> None:
    """The file of the tests says itself that it runs the engine, and finds the version where it runs."""
    if request.config.getoption("--engines") != "all":
        pytest.skip("left out: the table tells of runs with --engines all")
    row = EVIDENCE[name]
    assert row.version.split(".")[:2] == version_of(row)().split(".")[:2], "run tests/tools/evidence.py"


def test_executed_is_what_the_tests_run_on() -> None:
    executed = [row for row in EVIDENCE.values() if row.evidence == "executed"]
    assert {row.engine for row in executed} == set(engines.OPENERS) == set(engines.VERSIONS)
    assert [row.by for row in executed] == [engine_named(row.engine).title for row in executed]


@pytest.mark.parametrize("name", engines.OPENERS)
def test_an_older_version_is_refused_where_the_table_says_so(name: str) -> None:
    engine = engine_named(name)
    assert engine.oldest is not None
    first, *rest = map(int, engine.oldest.split("."))
    assert engine.is_too_old(".".join(map(str, (first - 1, *(99 for _ in rest), 99))))
    assert not engine.is_too_old(f"{engine.oldest}.1-some")


def test_every_refusal_can_be_told() -> None:
    """Each row has a class of errors of the user's, and no word that nobody fills in."""
    rows = list(csv.DictReader(data.text("gam_db.engines", "refusals.csv").splitlines()))
    words = {"path": "p", "journal": "j", "place": "p", "address": "a", "grant": "g", "name": "n"}
    for row in rows:
        sign = row["signs"].split("|")[0].replace("*", "").replace("[0-9]", "0")
        told = refusal(row["of"], sign, **words, master="m", first_line="f")
        assert isinstance(told, UserError), row
        assert "{" not in str(told), row
    open_ended = {row["of"] for row in rows if row["signs"] == "*"}
    assert open_ended == {
        *("duckdb_opening", "mariadb_connecting", "postgres_connecting", "spark_starting", "results")
    }
    assert refusal("sqlite", "no such table: x") is None


def test_the_first_set_names_tests_that_there_are() -> None:
    for slow, addresses in sets.FIRST.items():
        for address in addresses:
            file, _, test = address.partition("::")
            place = ROOT / "tests" / file
            assert list(place.parent.glob(f"{place.name}*")), (slow, address)
            name = test.partition("[")[0]
            assert not test or f"\ndef {name}" in place.read_text(encoding="utf-8"), (slow, address)


@pytest.mark.parametrize(
    ("address", "fixture", "engine", "named", "later"),
    [
        ("method/test_spec.py::test_cases[spark-30 cases: m=1]", "engine", "spark", "group", False),
        ("method/test_spec.py::test_cases[spark-9 cases: m=2]", "engine", "spark", "group", True),
        ("method/test_spec.py::test_cases[mariadb-9 cases: m=2]", "engine", "mariadb", "group", False),
        ("method/test_wide.py::test_wide[mariadb]", "engine", "mariadb", "group", True),
        ("method/test_wide.py::test_wide[duckdb]", "engine", "duckdb", "group", False),
        ("export/test_script.py::test_script[spark]", "engine", "spark", "engine", False),
        ("engines/test_spark_files.py::test_files", "tmp_path", None, None, True),
        ("report/test_report_page.py::test_it_prints", "chrome", None, None, True),
        ("report/test_report_page.py::test_every_figure_is", "chrome", None, None, False),
        ("method/test_langevin.py::test_it", "tmp_path", None, None, False),
    ],
)
def test_what_is_listed_of_a_slow_engine_is_in_the_first_set(
    address: str, fixture: str, engine: str | None, named: str | None, later: bool
) -> None:
    """A test that names its engines itself, as those of texts do, is in the first set on all of them."""
    marks = [pytest.mark.parametrize(named, ["a"]).mark] if named else []
    test = SimpleNamespace(
        nodeid=f"tests/{address}",
        path=Path(address.partition("::")[0]),
        fixturenames=[fixture],
        iter_markers=lambda _: marks,
    )
    if engine:
        test.callspec = SimpleNamespace(params={"engine": engine})
    assert sets.is_later(test) == later  # type: ignore[arg-type]


def test_the_page_is_up_to_date() -> None:
    page = ROOT / "docs" / "engines.md"
    assert page.read_text(encoding="utf-8") == engine_page.text(), "python tests/tools/engine_page.py"


def test_what_is_refused_is_told_though_rows_were_lent(engine: str) -> None:
    """Within a transaction that has failed nothing can be dropped, and that is not what went wrong."""
    session = engines.session(engine)
    rows = pa.table({"a": [1]})
    with (
        pytest.raises((StatementError, UserError)) as refused,
        session.transaction(),
        session.lent(rows) as lent,
    ):
        session.fetch(exp.select("nothing_such").from_(lent))
    told = f"{refused.value} {refused.value.__cause__}"
    assert "nothing_such" in told.lower()
    assert session.fetch(exp.select("a").from_(session.load(rows))).num_rows == 1


@pytest.mark.parametrize(("before", "shown"), [(4095, "LAST_VALUE"), (4096, "MAX")])
def test_the_newest_of_many_rows_is_the_largest(before: int, shown: str) -> None:
    """DuckDB goes back row by row: among few that costs least, among many it is told that times grow."""
    told: dict[str, template.Slot] = {
        "is_such": exp.column("code").eq(0),
        "rows": before,
        "long_ago": -1,
    }
    newest = template.fill("embedding/newest", told)
    rows = ", ".join(f"(7, {time}, {int(time % 5000 > 0)})" for time in range(9000))
    text = engine_named("duckdb").text(newest)
    assert shown in text
    query = f"SELECT time, {text} FROM (VALUES {rows}) AS codes (channel_id, time, code)"
    found = dict(duckdb.execute(query).fetchall())
    expected = {time: time - time % 5000 for time in range(9000)}
    if shown == "LAST_VALUE":
        expected |= {time: -1 for time in range(9000) if time % 5000 > before}
    assert found == expected


def test_only_a_running_count_is_added_up_as_double() -> None:
    """Other sums of whole numbers may be beyond 2^53, where DOUBLE leaves some out."""
    order = "PARTITION BY c ORDER BY t ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW"
    texts = {
        f"CAST(SUM(CASE WHEN a = 1 THEN 1 ELSE 0 END) OVER ({order}) AS BIGINT)": True,
        f"CAST(SUM(CASE WHEN a = 1 THEN b ELSE 0 END) OVER ({order}) AS BIGINT)": False,
        f"CAST(SUM(CASE WHEN a = 1 THEN 1 END) OVER ({order}) AS BIGINT)": False,
        f"CAST(SUM(CASE WHEN a = 1 THEN 9 ELSE 0 END) OVER ({order}) AS BIGINT)": False,
        f"CAST(SUM(b) OVER ({order}) AS BIGINT)": False,
        "CAST(SUM(CASE WHEN a = 1 THEN 1 ELSE 0 END) AS BIGINT)": False,
    }
    for text, is_one in texts.items():
        tree = sqlglot.parse_one(text, dialect="duckdb")
        assert ("DOUBLE" in engine_named("duckdb").text(tree)) is is_one, text
