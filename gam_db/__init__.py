"""gam-db: a health indicator for every machine channel, by plain SQL where the telemetry lies.

Importing it loads nothing but this file: each name is imported from its module when it is asked for.
Which names are public, and where each is made, is said in ``__init__.pyi``.
"""

import re
from importlib import import_module
from pathlib import Path
from typing import Any

_STUB = Path(__file__).with_suffix(".pyi").read_text(encoding="utf-8")

#: public name -> its module
_MODULE_OF = {
    name: module for module, name in re.findall(r"^from (\S+) import (\w+)", _STUB, re.MULTILINE)
}

__all__ = sorted(_MODULE_OF)


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for."""
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_MODULE_OF[name]), name)


def __dir__() -> list[str]:
    """Return the public names, imported or not, and no others."""
    return list(__all__)
