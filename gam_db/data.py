"""Tables and words that lie beside the code as files; and how files are written."""

import contextlib
import secrets
import shutil
import tomllib
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any


def text(package: str, name: str) -> str:
    """Return the text of a file that lies in a package."""
    return (resources.files(package) / name).read_text(encoding="utf-8")


@cache
def table(package: str, name: str) -> dict[str, Any]:
    """Return what a TOML file in a package says; it must not be changed."""
    return tomllib.loads(text(package, name))


def put(path: Path, content: bytes) -> None:
    """Write a file whole or not at all, beside what was there before; a device or pipe as it comes.

    Raises:
        OSError: it cannot be written.
    """
    if path.exists() and not path.is_file():
        path.write_bytes(content)
        return
    target = path.resolve()  # a link stays one
    unfinished = target.with_name(f".{target.name}.{secrets.token_hex(4)}")
    try:
        unfinished.write_bytes(content)
        if target.exists():
            shutil.copymode(target, unfinished)
        unfinished.replace(target)
    finally:
        with contextlib.suppress(OSError):
            unfinished.unlink(missing_ok=True)
