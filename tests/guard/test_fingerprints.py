"""Every text that is rendered is the one it was, unless a commit means to change it."""

from pathlib import Path

import pytest

import fingerprints
import gam_db
from gam_db.engines import NAMES
from gam_db.export.models import ADAPTERS

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]


@pytest.mark.parametrize("name", NAMES)
def test_texts_are_what_they_were(name: str) -> None:
    differing = fingerprints.differing(fingerprints.kept(name), fingerprints.fingerprints(name))
    assert not differing, (
        f"{len(differing)} rendered texts are not what they were:\n"
        + "\n".join(differing)
        + f"\nIf that is meant, write {fingerprints.FILE.name} anew by `{fingerprints.COMMAND}`, in a "
        "commit that changes nothing else than what is named here."
    )


def test_the_file_keeps_every_engine_and_nothing_else() -> None:
    lines = fingerprints.FILE.read_text(encoding="utf-8").splitlines()
    assert lines == sorted(lines)
    assert {line.partition(" / ")[0] for line in lines} == set(NAMES)
    packaged = {line.partition(" / ")[0] for line in lines if " / dbt / " in line}
    assert packaged == set(ADAPTERS)


def test_a_text_that_is_another_is_named() -> None:
    before = {"a / exact / plain": "1", "a / exact / gone": "2", "a / view / plain": "3"}
    now = {"a / exact / plain": "9", "a / view / plain": "3", "a / exact / added": "4"}
    assert fingerprints.differing(before, now) == [
        *("new: a / exact / added", "gone: a / exact / gone", "changed: a / exact / plain"),
    ]
    assert fingerprints.differing(before, before) == []


def test_a_small_change_changes_the_fingerprint() -> None:
    text = gam_db.render("exact", "duckdb", *fingerprints.SCRIPTS["plain"])
    marks = {fingerprints.fingerprint(one) for one in (text, f"{text}\n", text.replace(">", ">=", 1))}
    assert len(marks) == 3
    released = gam_db.__version__
    assert fingerprints.fingerprint(f"by {released}") == fingerprints.fingerprint("by VERSION")


def test_the_file_is_written_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fingerprints, "NAMES", ("sqlite",))
    monkeypatch.setattr(fingerprints, "texts_of", lambda engine: [(f"{engine} / exact / one", "x")])
    file = tmp_path / "fingerprints.txt"
    file.write_text("sqlite / exact / one  0\nsqlite / exact / two  0\n")
    assert fingerprints.write(file) == ["changed: sqlite / exact / one", "gone: sqlite / exact / two"]
    assert fingerprints.kept("sqlite", file) == fingerprints.fingerprints("sqlite")
