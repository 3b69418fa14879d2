"""The catalogue of ``sql/``, from its heads: ``python tests/tools/sql_page.py > sql/README.md``."""

import re
from pathlib import Path

from gam_db.composing.template import sql_folder

HEAD = """\
# The catalogue of `sql/`

Every formula is one file, in DuckDB's dialect, with named slots (`:stride`) for parameters. A file is a
step, one SELECT that reads other steps, or a fragment, an expression that stands in a slot of one. The
folders stand here in the order in which readings become a judgement. Equations are those of the paper,
sections those of the method. This page is made from the heads of the files:
`python tests/tools/sql_page.py > sql/README.md`.
"""

#: The folders in order, and what each is for.
ROOMS = {
    "source": "From a relation to samples: one value per channel and instant (section 2).",
    "census": "The same where it is taken on trust, and proven later, that no instant occurs twice.",
    "rowids": "Delay vectors and runs of an engine that numbers its rows (SQLite).",
    "arrays": "Delay vectors of an engine with arrays (ClickHouse).",
    "streams": "The same where channels are stored in order of time.",
    "calibration": "When calibration begins and ends, and what may be learnt from (section 4).",
    "range": "Which few calibration samples are left out of a range (both sides, section 1).",
    "support": "The range of a channel, the code of a sample, the cells of calibration (section 3).",
    "embedding": "Delay vectors and their cells.",
    "score": "Which vectors are scored, and which of them are novel.",
    "health": "The health indicator, by vector and by bucket.",
    "certificate": "What calibration says about itself (section 5).",
    "automatic": "Which delay, bins and window calibration chooses (both sides, section 4).",
    "probe": "What the indicator would show if a machine changed (both sides, section 2).",
    "program": "Which program a machine runs, where a column says so (both sides, section 5).",
    "script": "What a script spells out of the method: channels are called by their names.",
    "judgement": "When a channel is above its limit, and its status: the same in every form.",
    "alarms": "Judgements, the limits they are judged by, and episodes (alarms, sections 2 to 4).",
    "stored/state": "The stored form: what is there of monitors, channels, versions and runs.",
    "stored/calibrating": "What a new version freezes, and the sums that tell damage.",
    "stored/scoring": "From where a run reads, what it counts, and the rows that it appends.",
    "stored/monitor": "What a run decides where no Python runs between its statements.",
    "stored/alarms": "What is judged by a run, the episodes that follow, and what people are told.",
    "stored/checking": "What must hold between the tables, and between them and the source.",
    "stored/pruning": "Which rows go.",
    "report": "What the page for people who look is made of.",
    "export": "What a dbt package has instead.",
    "check": "What a source is like, before anything is learnt.",
    "selection": "The choice of delay, dimension, cycle, window and grid (section 8).",
    "lab/estimators": "Other estimators of the framework.",
    "lab/baselines": "What the reproduction compares with.",
    "lab/evaluation": "How well an indicator shows wear (section 9).",
    "lab/benchmark": "What is measured.",
}

_PARTS = ("Reads", "A row", "Slots")


def head(path: Path) -> dict[str, str]:
    """The head of a file in its parts: title, text, and as far as they are there reads, a row, slots."""
    lines = path.read_text(encoding="utf-8").splitlines()
    said = [line.removeprefix("--").strip() for line in lines if line.startswith("--")]
    found, part = {"": ""}, ""
    for line in said:
        name, colon, rest = line.partition(":")
        if colon and name in _PARTS:
            part, line = name, rest.strip()
        found[part] = f"{found.get(part, '')} {line}".strip()
    _, _, text = found.pop("").partition(": ")
    return {"text": text if text[1:2] == "(" else f"{text[:1].upper()}{text[1:]}", **found}


def equations(text: str) -> str:
    """The equations and sections that a text names."""
    named = re.findall(r"Eq\. \d(?: (?:and|to) (?:Eq\. )?\d)?", text)
    sections = [f"§ {number}" for number in re.findall(r"section (\d)", text)]
    return ", ".join(dict.fromkeys([*named, *sections]))


def row(path: Path) -> str:
    """The row of a file."""
    said = head(path)
    reads = re.sub(r"(^|, )(\w+)(?=,|$)", r"\1`\2`", said.get("Reads", ""))
    cells = [
        f"[{path.stem}]({path.relative_to(sql_folder()).as_posix()})",
        equations(said["text"] + said.get("A row", "")),
        said["text"],
        reads,
        said.get("A row", "" if reads else "a fragment"),
    ]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def text() -> str:
    """The whole page."""
    parts = [HEAD]
    for room, purpose in ROOMS.items():
        rows = [row(path) for path in sorted((sql_folder() / room).glob("*.sql"))]
        title = ["| file | equation | what | reads | a row |", "|---|---|---|---|---|"]
        parts.append("\n".join([f"## {room}", "", purpose, "", *title, *rows]) + "\n")
    return "\n".join(parts)


if __name__ == "__main__":
    print(text(), end="")
