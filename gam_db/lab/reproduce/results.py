"""Results as files: one small JSON per run with its settings, used again where they match."""

import json
import platform
import secrets
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from gam_db.errors import ConfigurationError

FOLDER = Path("gam-reproduce")
_LIBRARIES = ("gam-db", "duckdb", "numpy", "scikit-learn", "torch")

Figures = dict[str, Any]

Show = Callable[[str], None]
"""Told what is at work."""


@dataclass(frozen=True)
class Results:
    """A folder of results.

    Attributes:
        folder: where the files are; it is made when the first one is written.
    """

    folder: Path

    def get(self, name: str, settings: Mapping[str, Any], compute: Callable[[], Figures]) -> Figures:
        """Return the figures of a run: those of its file if it had these settings, else computed.

        Args:
            name: of the run, and of its file.
            settings: all that the figures depend on, as JSON can say it.
            compute: runs it; its figures are written before they are returned.

        Raises:
            ConfigurationError: there is a file of that name that is no result, or none can be written.
        """
        file = self.folder / f"{name}.json"
        stored = _read(file)
        if stored is not None and stored["settings"] == json.loads(json.dumps(settings)):
            return dict(stored["figures"])
        figures = compute()
        record = {"settings": settings, "figures": figures, "made_with": _versions()}
        unfinished = file.with_name(f".{file.name}.{secrets.token_hex(4)}")
        try:
            file.parent.mkdir(parents=True, exist_ok=True)
            unfinished.write_text(json.dumps(record, indent=2) + "\n", encoding="utf-8")
            unfinished.replace(file)
        except OSError as error:
            raise ConfigurationError(
                f"{file} cannot be written; give another folder by --results."
            ) from error
        return figures


def _read(file: Path) -> dict[str, Any] | None:
    try:
        record = json.loads(file.read_text(encoding="utf-8"))
        if isinstance(record["settings"], dict) and isinstance(record["figures"], dict):
            return dict(record)
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, TypeError):
        pass
    raise ConfigurationError(
        f"{file} is no result of gam reproduce; remove it, or give another --results."
    )


def _versions() -> dict[str, str]:
    versions = {"python": platform.python_version()}
    for library in _LIBRARIES:
        try:
            versions[library] = metadata.version(library)
        except metadata.PackageNotFoundError:
            continue
    return versions
