"""Counts vague words in identifiers: ``python tests/tools/vague_words.py [--files | --identifiers]``.

These words tell how something came into a variable or column, not what it is. An identifier is split at
``_`` and capitals, and each part that is one of the words counts once. Comments and texts do not count.
It prints the uses of each word and their sum, for Python and for SQL; ``--files`` prints the uses per
file, ``--identifiers`` those per identifier.
"""

import ast
import io
import re
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[2]
WORDS = frozenset(
    ("one", "said", "found", "known", "asked", "own", "made", "told", "placed", "given", "kept")
)
#: Where SQL lies; Python is counted in gam_db alone.
SQL_FOLDERS = ("gam_db", "sql", "migrations")
#: Folders of other programs.
FOREIGN = frozenset({"node_modules", "__pycache__"})

_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_FORMATTED = re.compile("[bru]*f", re.IGNORECASE)
_SQL_TEXT = re.compile(r"--[^\n]*|/\*.*?\*/|'(?:[^']|'')*'", re.DOTALL)
_SQL_NAME = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")


def vague_parts(identifier: str) -> list[str]:
    """Return the vague words of an identifier, as often as each occurs."""
    return [part for part in map(str.lower, _PARTS.findall(identifier)) if part in WORDS]


def python_identifiers(source: str) -> Iterator[str]:
    """Return the identifiers of Python source, those inside of f-strings included."""
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.NAME:
            yield token.string
        elif token.type == tokenize.STRING and _FORMATTED.match(token.string):
            yield from _inside(token.string)  # Python 3.12 gives these as tokens of their own


def _inside(text: str) -> Iterator[str]:
    """Return the identifiers in the braces of an f-string."""
    for node in ast.walk(ast.parse(text, mode="eval")):
        for field in ("id", "attr", "arg"):
            if isinstance(name := getattr(node, field, None), str):
                yield name


def sql_identifiers(source: str) -> Iterator[str]:
    """Return the identifiers of SQL source: names of steps, aliases, columns and slots."""
    yield from _SQL_NAME.findall(_SQL_TEXT.sub(" ", source))


def identifiers(path: Path) -> Iterator[str]:
    """Return the identifiers of a file of Python or SQL."""
    source = path.read_text(encoding="utf-8")
    return (python_identifiers if path.suffix == ".py" else sql_identifiers)(source)


def files(root: Path = ROOT) -> list[Path]:
    """Return the files that are counted, in order."""
    found = list((root / "gam_db").rglob("*.py"))
    for folder in SQL_FOLDERS:
        found += (root / folder).rglob("*.sql")
    return sorted(path for path in found if not FOREIGN.intersection(path.parts))


def uses(root: Path = ROOT) -> dict[Path, Counter[str]]:
    """Return the identifiers with a vague word of each file that has any, with the number of uses."""
    counts = {}
    for path in files(root):
        vague = Counter(identifier for identifier in identifiers(path) if vague_parts(identifier))
        if vague:
            counts[path] = vague
    return counts


def total(counts: Counter[str]) -> int:
    """Return how many vague words are in counted identifiers."""
    return sum(len(vague_parts(identifier)) * times for identifier, times in counts.items())


def by_word(counts: Counter[str]) -> Counter[str]:
    """Return the uses of each vague word."""
    words: Counter[str] = Counter()
    for identifier, times in counts.items():
        for word in vague_parts(identifier):
            words[word] += times
    return words


def text(choice: str = "", root: Path = ROOT) -> str:
    """Return the page: by word, or by file or identifier where ``choice`` says so."""
    of_file = uses(root)
    every: Counter[str] = sum(of_file.values(), Counter())
    if choice == "--files":
        rows = Counter({str(path.relative_to(root)): total(counts) for path, counts in of_file.items()})
        return _lines(rows)
    if choice == "--identifiers":
        return _lines(Counter({name: total(Counter({name: times})) for name, times in every.items()}))
    lines = [f"{'word':10}{'Python':>8}{'SQL':>8}{'both':>8}"]
    kinds = [
        by_word(sum((counts for path, counts in of_file.items() if path.suffix == suffix), Counter()))
        for suffix in (".py", ".sql")
    ]
    for word in sorted(WORDS):
        python, sql = (kind[word] for kind in kinds)
        lines.append(f"{word:10}{python:8}{sql:8}{python + sql:8}")
    python, sql = (kind.total() for kind in kinds)
    return "\n".join([*lines, f"{'all':10}{python:8}{sql:8}{python + sql:8}"])


def _lines(rows: Counter[str]) -> str:
    ordered = sorted(rows.items(), key=lambda row: (-row[1], row[0]))
    return "\n".join([f"{times:6}  {name}" for name, times in ordered] + [f"{rows.total():6}  all"])


if __name__ == "__main__":
    print(text(sys.argv[1] if sys.argv[1:] else ""))
