"""Figures for a notebook: the names of :mod:`gam_db.lab.plot`, imported when they are used."""

from importlib import import_module
from typing import Any


def __getattr__(name: str) -> Any:
    return getattr(import_module("gam_db.lab.plot"), name)
