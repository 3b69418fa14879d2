"""Templates are filled strictly and safely, and nothing else in the package makes SQL from text."""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

import duckdb
import pytest
from sqlglot import exp

import gam_db
import sql_lint
from gam_db.composing import template
from gam_db.engines.duckdb import ENGINE
from gam_db.errors import TemplateError

PACKAGE = Path(gam_db.__file__).parent


def filled(source: str, slots: Mapping[str, template.Slot]) -> exp.Expr:
    return template.fill_template(template.parse("folder/file", source), slots)


def sql(source: str, **slots: template.Slot) -> str:
    return ENGINE.text(filled(source, slots))


def answer(source: str, **slots: template.Slot) -> object:
    """Run a filled template and return its last column: what DuckDB makes of it is no opinion."""
    row = duckdb.connect().execute(sql(source, **slots)).fetchone()
    assert row is not None
    return row[-1]


# Reading a file


@pytest.mark.parametrize(
    ("source", "message"),
    [
        ("SELECT 1 AS a; SELECT 2 AS a", "exactly one statement"),
        ("SELECT 1 AS a; DROP TABLE t", "exactly one statement"),
        ("-- nothing but a comment", "exactly one statement"),
        ("SELECT * FROM t", "selects \\*"),
        ("SELECT t.* FROM t", "selects \\*"),
        ("SELECT a FROM (SELECT * FROM t) AS q", "selects \\*"),
        ("SELECT epoch_us(a) AS b FROM t", "unknown function epoch_us"),
        ("SELECT a FROM t WHERE isfinit(a)", "unknown function isfinit"),
        ("SELECT SUM(a) OVER w AS b FROM t WINDOW w AS (ORDER BY a)", "names a window"),
        ("SELECT FROM WHERE", "cannot be parsed"),
        ("SELECT 'open AS a", "cannot be parsed"),
        ("VACUUM t", "not a query"),
        ("SELECT ? AS a", "parameter"),
    ],
)
def test_a_file_that_breaks_a_rule_is_refused(source: str, message: str) -> None:
    try:
        (said,) = {*sql_lint.form(template.parse("folder/file", source))}
    except TemplateError as error:
        said = str(error)
    assert "sql/folder/file.sql" in said
    assert re.search(message, said)


def test_counting_rows_is_no_star() -> None:
    assert sql("SELECT COUNT(*) AS rows_in FROM t") == "SELECT COUNT(*) AS rows_in FROM t"


def test_a_missing_file_is_named() -> None:
    with pytest.raises(TemplateError, match=r"no template sql/folder/none\.sql"):
        template.load("folder/none")


def test_what_a_file_says_of_itself_and_its_slots_are_kept() -> None:
    found = template.parse("f", "-- Name: what it is.\n-- Slots:  :a\nSELECT 1 AS one, :a AS a, :b AS b")
    assert found.comment == "Name: what it is."
    assert found.slots == {"a", "b"}


# Filling


@pytest.mark.parametrize(
    ("slots", "message"),
    [
        ({"a": 1}, "no value for b"),
        ({}, "no value for a, b"),
        ({"a": 1, "b": 2, "c": 3}, "no such slot: c"),
        ({"a": 1, "c": 3}, "no value for b; no such slot: c"),
    ],
)
def test_slots_given_and_slots_there_are_the_same(
    slots: Mapping[str, template.Slot], message: str
) -> None:
    with pytest.raises(TemplateError, match=message):
        filled("SELECT 1 AS one, :a AS a, :b AS b", slots)


def test_no_slot_is_left_over_inside_a_value() -> None:
    """A forgotten slot would be printed as a bind variable and only fail at the engine."""
    with pytest.raises(TemplateError, match="later"):
        filled("SELECT 1 AS one, :a + 1 AS a", {"a": exp.Placeholder(this="later")})
    with pytest.raises(TemplateError, match="later"):
        filled("SELECT 1 AS one, :a", {"a": [exp.alias_(exp.Placeholder(this="later"), "b")]})


@pytest.mark.parametrize(
    "value", [float("nan"), float("inf"), float("-inf"), 2**63, -(2**63) - 1, 10**30]
)
def test_a_number_that_sql_cannot_hold_is_refused(value: float) -> None:
    """NaN and infinity would turn into NULL without a word."""
    with pytest.raises(TemplateError, match=r"finite|64 bits"):
        filled("SELECT 1 AS one, :a AS a", {"a": value})


@pytest.mark.parametrize("value", [True, "text", b"bytes", object()])
def test_only_numbers_nodes_and_null_stand_in_a_slot(value: object) -> None:
    with pytest.raises(TemplateError):
        filled("SELECT 1 AS one, :a AS a", {"a": value})  # type: ignore[dict-item]


@pytest.mark.parametrize(
    "value", [0, -1, 2**63 - 1, 0.1, -0.1, 1e300, -1e-300, 5e-324, 0.9918324058718997, -0.0]
)
def test_numbers_arrive_as_they_are(value: float) -> None:
    found = answer("SELECT 1 AS one, :a AS a", a=value)
    assert type(found) is type(value)
    assert repr(found) == repr(value)


def test_none_is_null() -> None:
    assert answer("SELECT 1 AS one, CAST(:a AS BIGINT) AS a", a=None) is None


def test_a_list_becomes_columns() -> None:
    terms = [exp.alias_(exp.Literal.number(n), f"c{n}") for n in (1, 2)]
    assert sql("SELECT x, :more, y FROM t", more=terms) == "SELECT x, 1 AS c1, 2 AS c2, y FROM t"
    assert sql("SELECT x, :more, y FROM t", more=[]) == "SELECT x, y FROM t"  # m = 1 has no delay
    ordered = "SELECT ROW_NUMBER() OVER (ORDER BY x, :more) AS place FROM t"
    assert sql(ordered, more=[exp.column("y")]) == (
        "SELECT ROW_NUMBER() OVER (ORDER BY x, y) AS place FROM t"
    )
    assert sql(ordered, more=[]) == "SELECT ROW_NUMBER() OVER (ORDER BY x) AS place FROM t"


@pytest.mark.parametrize(
    "source",
    ["SELECT a FROM t WHERE :many", "SELECT 1 AS b, :many + 1 AS a", "SELECT a FROM t LIMIT :many"],
)
def test_a_list_stands_nowhere_else(source: str) -> None:
    with pytest.raises(TemplateError, match=":many takes a list only among columns"):
        filled(source, {"many": [exp.Literal.number(1), exp.Literal.number(2)]})


def test_filling_copies() -> None:
    source = template.parse("f", "SELECT 1 AS one, :a AS a, :a AS b FROM t")
    before = source.tree.sql()
    node = exp.column("x")
    first = template.fill_template(source, {"a": node})
    for column in first.find_all(exp.Column):
        column.set("this", exp.to_identifier("changed"))
    assert node.sql() == "x"
    assert node.parent is None
    assert source.tree.sql() == before
    assert template.fill_template(source, {"a": node}).sql() == "SELECT 1 AS one, x AS a, x AS b FROM t"
    listed = [exp.column("y")]
    second = template.fill_template(template.parse("f", "SELECT 1 AS one, :a FROM t"), {"a": listed})
    assert next(second.find_all(exp.Column)) is not listed[0]


# Brackets: what is put in must mean what it meant, whatever stands beside the slot


@pytest.mark.parametrize(
    ("source", "value", "expected"),
    [
        ("SELECT 1 AS one, 2 * :a AS a", "1 + 2", 6),
        ("SELECT 1 AS one, :a * 2 AS a", "1 + 2", 6),
        ("SELECT 1 AS one, 9 - :a AS a", "5 - 3", 7),
        ("SELECT 1 AS one, 0 - :a AS a", "1 + 2", -3),
        ("SELECT 1 AS one, FALSE AND :a AS a", "FALSE OR TRUE", False),
        ("SELECT 1 AS one, NOT (:a) AS a", "FALSE AND FALSE", True),
        ("SELECT 1 AS one, 7 % :a AS a", "2 + 3", 2),
        ("SELECT 1 AS one, 3 BETWEEN :a AND 4 AS a", "2 + 2", False),
        ("SELECT 1 AS one, :a IN (TRUE) AS a", "TRUE OR FALSE", True),
        ("SELECT 1 AS one, FALSE = :a AS a", "1 BETWEEN 2 AND 3", True),
        ("SELECT 1 AS one, :a = FALSE AS a", "1 BETWEEN 2 AND 3", True),
        ("SELECT 1 AS one, :a = FALSE AS a", "1 IN (2, 3)", True),
        ("SELECT 1 AS one, :a IS NULL AS a", "NULL AND FALSE", False),
    ],
)
def test_compound_values_keep_together(source: str, value: str, expected: object) -> None:
    alias = template.parse("value", f"SELECT {value} AS v").tree.find(exp.Alias)
    assert alias is not None
    assert answer(source, a=alias.this) == expected


def test_a_negative_number_makes_no_comment() -> None:
    assert answer("SELECT 5 - :a AS a", a=-3) == 8
    assert answer("SELECT 1 AS one, 0 - :a AS a", a=-0.5) == 0.5


# Hostile names and texts

HOSTILE = [
    'quo"te',
    "it's",
    "x; DROP TABLE t; --",
    '"; DROP TABLE t; --',
    "'; DROP TABLE t; --",
    "/* comment",
    ":slot",
    "$1",
    "?",
    "back\\slash",
    "\\'",
    "new\nline",
    "%s {0} {brace}",
    "select",
    "Größe 机器 😀",
    " blanks ",
    "dot.ted",
    "x" * 200,
]


@pytest.mark.parametrize("hostile", HOSTILE)
def test_names_and_texts_stay_what_they_are(hostile: str) -> None:
    connection = duckdb.connect()
    statement = sql("SELECT 1 AS one, :text AS a", text=template.text(hostile))
    assert connection.execute(statement).fetchall() == [(1, hostile)]
    inner = exp.select(exp.alias_(exp.Literal.number(7), template.name(hostile)))
    aliased = filled("SELECT 1 AS one, :column AS a FROM inside", {"column": template.column(hostile)})
    for table in list(aliased.find_all(exp.Table)):
        table.replace(inner.subquery("inside"))
    assert connection.execute(ENGINE.text(aliased)).fetchall() == [(1, 7)]


# No SQL from text, anywhere in the package

SQL_WORDS = re.compile(r"\b(SELECT|INSERT|UPDATE|DELETE|CREATE|DROP|FROM|WHERE)(\s|$)")
JOINING = ("format", "format_map", "join", "replace")


def sql_texts(source: str) -> Iterator[str]:
    """The pieces of text with SQL in them that Python code puts together with others."""
    for node in ast.walk(ast.parse(source)):
        pieces: list[ast.expr] = []
        if isinstance(node, ast.JoinedStr):
            pieces = node.values
        elif isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Mod)):
            pieces = [node.left, node.right]
        elif isinstance(node, ast.AugAssign):
            pieces = [node.value]
        elif isinstance(node, ast.Call) and getattr(node.func, "attr", "") in JOINING:
            pieces = [getattr(node.func, "value", node.func), *node.args]
        for piece in pieces:
            text = piece.value if isinstance(piece, ast.Constant) else None
            if isinstance(text, str) and SQL_WORDS.search(text):
                yield f"line {piece.lineno}: {text.strip()[:60]}"


@pytest.mark.parametrize(
    "source",
    [
        'f"SELECT {x}"',
        '"SELECT a FROM " + table',
        'text + " WHERE a = 1"',
        '"DELETE FROM %s" % table',
        '"CREATE TABLE {} (a INT)".format(name)',
        '" FROM t JOIN ".join(parts)',
        'query += " WHERE a"',
        'query.replace("x", "DROP TABLE t")',
    ],
)
def test_the_scan_for_sql_texts_finds_them(source: str) -> None:
    assert list(sql_texts(source))


def test_the_scan_lets_trees_and_plain_words_pass() -> None:
    assert not list(sql_texts('exp.select("a").from_("t"); f"from {a} where {b}"'))


def test_no_sql_is_made_from_text() -> None:
    found = {
        f"{path.relative_to(PACKAGE)} {text}"
        for path in PACKAGE.rglob("*.py")
        for text in sql_texts(path.read_text(encoding="utf-8"))
    }
    assert not found


# What imports what

HEAVY = [
    *("sklearn", "scipy", "torch", "pandas", "polars", "matplotlib"),
    *("psycopg", "pyspark", "chdb", "clickhouse_connect", "pymysql", "adbc_driver_manager"),
    *("google.cloud", "snowflake", "typer", "rich"),
]


def test_importing_the_package_imports_nothing_heavy() -> None:
    """None of them may even be tried: the import must work, and be quick, where they are missing."""
    program = (
        "import sys\n"
        f"heavy = {HEAVY!r}\n"
        "for name in heavy: sys.modules[name] = None\n"  # importing one would raise
        "import gam_db\n"
        "print([name for name in heavy if sys.modules[name] is not None])\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=False,
        cwd=PACKAGE.parent,
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout.strip() == "[]"
