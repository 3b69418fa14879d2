"""What is installed: bounded where another major version may change results, and locked for CI."""

import re
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).parent.parent.parent
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]

#: What stores rows, computes or writes SQL: a major version of it may do so otherwise.
TOLD_APART = {
    *("duckdb", "sqlglot", "numpy", "psycopg", "chdb", "clickhouse-connect", "pyspark"),
    *("scikit-learn", "scipy"),
}


def locked(name: str) -> dict[str, list[str]]:
    """Return the versions that a lock file names, one for each Python where they differ."""
    text = (ROOT / ".ci" / name).read_text(encoding="utf-8")
    found: dict[str, list[str]] = {}
    for package, version in re.findall(r"^([a-z0-9-]+)(?:\[.*\])?==([^\s;]+)", text, re.MULTILINE):
        found.setdefault(package, []).append(version)
    return found


def wanted() -> list[Requirement]:
    """Return what CI installs, as the project says it."""
    said = [*PROJECT["dependencies"], *(one for extra in EXTRAS.values() for one in extra)]
    return [one for one in map(Requirement, said) if one.name not in ("gam-db", "torch")]


@pytest.mark.parametrize("requirement", wanted(), ids=str)
def test_the_lock_file_of_ci_is_within_the_bounds(requirement: Requirement) -> None:
    versions = locked("gam.txt")[requirement.name]
    assert all(requirement.specifier.contains(version) for version in versions), "renew the lock file"
    if requirement.name in TOLD_APART:
        assert not requirement.specifier.contains("99"), "a major version may change results"


def test_dbt_runs_on_the_same_duckdb() -> None:
    assert locked("dbt.txt")["duckdb"] == locked("gam.txt")["duckdb"]


def test_ci_installs_what_is_locked() -> None:
    script = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    assert '--constraints .ci/gam.txt -e ".[test,engines]"' in script
    assert "--requirements .ci/dbt.txt" in script
    (allowed,) = (one for one in PROJECT["dependencies"] if Requirement(one).name == "duckdb")
    assert f'--resolution "$age" "{allowed}"' in script
