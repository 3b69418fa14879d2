"""The list of mutants fits the SQL, and a mutant is told apart from what it is made of."""

import pytest

import mutants
from gam_db.composing import template
from mutants import Mutant


def test_every_file_has_a_mutant() -> None:
    there = {
        path.relative_to(template.sql_folder()).with_suffix("").as_posix()
        for folder in mutants.FOLDERS
        for path in (template.sql_folder() / folder).rglob("*.sql")
    }
    assert there == {one.file for one in mutants.listed()}
    assert len(set(mutants.listed())) == len(mutants.listed()) >= 60


def test_every_mutant_is_another_query_that_can_be_parsed() -> None:
    """One that is refused before it runs would show nothing."""
    for one in mutants.listed():
        text = (template.sql_folder() / f"{one.file}.sql").read_text(encoding="utf-8")
        changed = template.parse(one.file, one.changed(text))
        assert changed.tree != template.load(one.file).tree, str(one)
        assert changed.slots == template.load(one.file).slots, str(one)


def test_only_the_query_is_changed_and_only_one_place() -> None:
    text = "-- a = 1\nSELECT b\nWHERE a = 1\n"
    assert Mutant("x", "a = 1", "a = 2").changed(text) == "-- a = 1\nSELECT b\nWHERE a = 2\n"
    for before in ("c", "E"):
        with pytest.raises(ValueError, match="not once"):
            Mutant("x", before, "d").changed(text)


def test_the_tests_that_run_are_there() -> None:
    there = {path.stem for path in (mutants.ROOT / "tests").rglob("test_*.py")}
    for one in (None, *mutants.listed()):
        assert {name.partition("[")[0] for name in mutants.tests_of(one)} <= there


def test_a_pattern_of_no_file_is_refused_before_anything_runs(
    capsys: pytest.CaptureFixture[str],
) -> None:
    with pytest.raises(SystemExit):
        mutants.main(["pruning"])
    assert "no mutant is of a file like pruning" in capsys.readouterr().err
