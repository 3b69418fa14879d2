"""Print how large what users read is, and how large the kernel: `python tests/tools/measures.py`."""

import io
import tokenize
from pathlib import Path

import gam_db
from gam_db.engines import engine_named
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables

ROOT = Path(__file__).parents[2]

#: The parts of the package that every form is made of; what is at its top belongs to them.
KERNEL = ("settings", "composing", "method", "study", "engines", "reading", "stored", "alarms")

_NO_CODE = (
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT),
    tokenize.ENDMARKER,
)


def size_of(text: str) -> str:
    """Return the characters and lines of a text."""
    return f"{len(text):,} characters, {len(text.splitlines()):,} lines"


def code_lines(text: str) -> int:
    """Return how many lines of a module hold code: no comment, docstring or blank line."""
    lines: set[int] = set()
    is_first = True  # of a statement, where a text alone is a docstring
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in _NO_CODE:
            is_first = is_first or token.type != tokenize.COMMENT
            continue
        if not (token.type == tokenize.STRING and is_first):
            lines.update(range(token.start[0], token.end[0] + 1))
        is_first = False
    return len(lines)


def main() -> None:
    """Print the measures."""
    source = gam_db.Source("telemetry", time_kind="timestamp")
    calibration = gam_db.Calibration(fraction=0.2)
    for engine in ("duckdb", "postgres"):
        script = gam_db.render("view", engine, source, gam_db.Parameters.paper(), calibration)
        print(f"gam compile, one plain table, view form, {engine}: {size_of(script)}")
    for engine in ("duckdb", "postgres"):
        print(f"gam migrate --sql, {engine}: {size_of(rendered(engine_named(engine), StateTables()))}")
    files = [*(ROOT / "gam_db").glob("*.py")]
    for part in KERNEL:
        files += (ROOT / "gam_db" / part).rglob("*.py")
    texts = [path.read_text(encoding="utf-8") for path in files]
    lines, code = (sum(map(count, texts)) for count in (lambda one: one.count("\n"), code_lines))
    print(f"kernel: {lines:,} lines, {code:,} of code; {len(files)} modules")
    for folder in ("sql", "migrations"):
        found = [path.read_text(encoding="utf-8") for path in (ROOT / folder).rglob("*.sql")]
        print(f"{folder}: {sum(one.count(chr(10)) for one in found):,} lines; {len(found)} files")


if __name__ == "__main__":
    main()
