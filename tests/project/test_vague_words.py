"""Identifiers say what they hold: few have a word that tells how it came to be."""

from collections import Counter
from pathlib import Path

import vague_words

MOST = 500
MOST_IN_SQL = 60


def test_few_identifiers_have_a_vague_word() -> None:
    of_file = vague_words.uses()
    counts = {path: vague_words.total(names) for path, names in of_file.items()}
    in_sql = {path: times for path, times in counts.items() if path.suffix == ".sql"}
    assert sum(in_sql.values()) <= MOST_IN_SQL, in_sql
    assert sum(counts.values()) <= MOST, Counter(counts).most_common(20)


def test_parts_of_identifiers_count_and_nothing_else(tmp_path: Path) -> None:
    """A word counts where it is a part of its own, once per use."""
    (tmp_path / "gam_db").mkdir()
    (tmp_path / "sql").mkdir()
    (tmp_path / "gam_db" / "counted.py").write_text(
        '''"""What is known."""
found_rows = onerous = "one"  # said
class MadeOne:
    told: str = f"{found_rows} given {onerous.kept!r}"
''',
        encoding="utf-8",
    )
    (tmp_path / "sql" / "counted.sql").write_text(
        "-- Known: asked.\nSELECT placed.own_code AS known, 'it''s one' AS unknown FROM t AS placed\n"
        "WHERE :known /* told */",
        encoding="utf-8",
    )
    (tmp_path / "sql" / "uncounted.md").write_text("known", encoding="utf-8")
    python, sql = (vague_words.uses(tmp_path)[path] for path in vague_words.files(tmp_path))
    assert python == {"found_rows": 2, "MadeOne": 1, "told": 1, "kept": 1}
    assert vague_words.by_word(python) == {"found": 2, "made": 1, "one": 1, "told": 1, "kept": 1}
    assert sql == {"placed": 2, "own_code": 1, "known": 2}
    assert vague_words.total(python) == 6
    assert vague_words.total(sql) == 5


def test_the_page_shows_words_files_and_identifiers(tmp_path: Path) -> None:
    (tmp_path / "migrations").mkdir()
    (tmp_path / "migrations" / "0001.sql").write_text("SELECT made_from FROM made", encoding="utf-8")
    assert vague_words.text(root=tmp_path).splitlines()[-1].split() == ["all", "0", "2", "2"]
    assert vague_words.text("--files", tmp_path).split() == ["2", "migrations/0001.sql", "2", "all"]
    expected = ["1", "made", "1", "made_from", "2", "all"]
    assert vague_words.text("--identifiers", tmp_path).split() == expected
