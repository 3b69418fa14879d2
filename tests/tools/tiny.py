"""Tests have few rows, to be fast: where they do not say otherwise, any calibration is judged.

And what they leave unsaid of delay, bins and window is as in the paper: nothing is chosen twice.
"""

import contextlib
import dataclasses
import inspect
from collections.abc import Iterator, Mapping
from typing import Any

from gam_db import Parameters
from gam_db.settings.parameters import OPENABLE
from gam_db.settings.setting import settings_of


def judge_any_calibration() -> None:
    """Let Parameters that say nothing of least_vectors take one, and be as in the paper else."""
    _default({**{name: Parameters.PAPER[name] for name in OPENABLE}, "least_vectors": 1})


@contextlib.contextmanager
def as_delivered() -> Iterator[None]:
    """Let Parameters be as users have them for a while."""
    _default({name: one.default for name, one in settings_of(Parameters).items()})
    try:
        yield
    finally:
        judge_any_calibration()


def _default(values: Mapping[str, Any]) -> None:
    for one in dataclasses.fields(Parameters):
        one.default = values.get(one.name, one.default)
    made: Any = inspect.unwrap(Parameters.__init__)  # what it was before its arguments were looked at
    made.__defaults__ = tuple(one.default for one in dataclasses.fields(Parameters))
