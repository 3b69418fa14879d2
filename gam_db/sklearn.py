"""A detector of scikit-learn: the name of :mod:`gam_db.lab.sklearn`, imported when it is used."""

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    return getattr(import_module("gam_db.lab.sklearn"), name)
