"""Tables and words that lie beside the code as files."""

import tomllib
from functools import cache
from importlib import resources
from typing import Any


def text(package: str, name: str) -> str:
    """Return the text of a file that lies in a package."""
    return (resources.files(package) / name).read_text(encoding="utf-8")


@cache
def table(package: str, name: str) -> dict[str, Any]:
    """Return what a TOML file in a package says; it must not be changed."""
    return tomllib.loads(text(package, name))
