"""What ``gam run`` says of programs that calibration holds nothing of, or too little."""

from collections import defaultdict
from collections.abc import Iterable

from gam_db.checking.words import extent
from gam_db.cli import page
from gam_db.errors import printable
from gam_db.findings import Row


def unjudged(rows: Iterable[Row]) -> list[Row]:
    """Return the rows of :func:`gam_db.programs` whose readings since calibration are not judged."""
    return [row for row in rows if row["verdict"] != "ready" and row["readings"]]


def lines(rows: Iterable[Row]) -> list[str]:
    """Return a line for each program of a machine that is not judged."""
    alike: dict[tuple[str, str, str | None], list[Row]] = defaultdict(list)
    for row in unjudged(rows):
        alike[row["asset"], row["verdict"], row["program"]].append(row)
    return [_line(*of, signals) for of, signals in alike.items()]


def _line(asset: str, verdict: str, program: str | None, rows: list[Row]) -> str:
    named = "no program is named"
    if program is not None:
        few = "is calibrated too little" if verdict == "needs_data" else "was never calibrated"
        named = f"program {printable(program)} {few}"
    signals = page.some([row["channel"] for row in rows])
    first = min(row["first_time"] for row in rows)
    since = f"{first:,}" if isinstance(first, int) else f"{first:%Y-%m-%d %H:%M} UTC"
    readings = extent([row["readings"] for row in rows])
    word = "reading" if readings == "1" else "readings"
    return f"{named} on {printable(asset)} ({signals}): {readings} {word} since {since}, not judged"
