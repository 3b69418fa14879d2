"""``gam engines``: which engines there are, and what is known of each at work.

This module owns the command; :mod:`gam_db.engines` owns what is said.
"""

import dataclasses
import json
import textwrap
from typing import Annotated, Any

import typer

from gam_db.engines import NAMES, engine_named
from gam_db.engines.evidence import evidence

_WIDTH = 100


def engines(
    as_json: Annotated[bool, typer.Option("--json", help="Print the same as JSON.")] = False,
) -> None:
    """Tell which engines gam-db writes SQL for, and what is known of each at work.

    *Executed* means that the tests run there and compare every integer; *rendered*, that the SQL is only
    made. Version and date are those of the last run of the tests.
    """
    found = [_figures(name) for name in NAMES]
    if as_json:
        print(json.dumps(found, indent=1))
        return
    print("\n\n".join("\n".join(_lines(row)) for row in found))


def _figures(name: str) -> dict[str, Any]:
    engine = engine_named(name)
    return {
        **dataclasses.asdict(evidence()[name]),
        "title": engine.title,
        "oldest": engine.oldest,
        "extra": engine.extra,
        "transactions": engine.transactions,
        "limits": engine.limits,
    }


def _lines(row: dict[str, Any]) -> list[str]:
    rest = [
        *([f"accepted from {row['oldest']} on"] if row["oldest"] else []),
        *([f'pip install "gam-db[{row["extra"]}]"'] if row["extra"] else []),
        "transactions" if row["transactions"] else "no transactions",
    ]
    lines = [
        f"{row['title']} ({row['engine']}): {row['evidence']}",
        f"by {row['by']} {row['version']} on {row['date']}, {row['tests']}",
        "; ".join(rest),
        *textwrap.wrap(row["limits"], _WIDTH),
    ]
    return [lines[0], *(f"  {line}" for line in lines[1:])]
