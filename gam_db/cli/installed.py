"""What is installed: the versions that ``gam --version --verbose`` prints, for a report of a fault.

Which libraries are asked after is what the package itself requires, with its extras.
"""

import platform
import re
import sqlite3
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path

#: Extras of those who work on gam-db; what else they hold is in the others.
_OF_WORK = ("engines", "test")

_REQUIRED = re.compile(r"""([\w.-]+)[^;]*(?:;.*extra == ['"]([\w-]+)['"])?""")


def lines() -> Iterator[str]:
    """Yield a line for each library that gam-db may use: its version, or what installs it."""
    yield f"Python {platform.python_version()}, SQLite {sqlite3.sqlite_version}, {platform.platform()}"
    yield f"gam-db is in {Path(__file__).parents[1]}"
    extras: dict[str, list[str]] = {}
    for required in _required():
        if match := _REQUIRED.fullmatch(required):
            extras.setdefault(match[1], []).append(match[2] or "")
    for library, names in extras.items():
        wanted = [name for name in names if name not in _OF_WORK]
        if wanted:
            yield f"{library} {_version(library) or f'is not installed: {_command(wanted)}'}"


def _required() -> list[str]:
    try:
        return requires("gam-db") or []
    except PackageNotFoundError:  # a folder on the path, which nobody installed
        return []


def _version(library: str) -> str | None:
    try:
        return version(library)
    except PackageNotFoundError:
        return None


def _command(extras: list[str]) -> str:
    return " or ".join(f'pip install "gam-db{f"[{extra}]" * bool(extra)}"' for extra in extras)
