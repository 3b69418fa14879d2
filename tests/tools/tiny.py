"""Tests have few rows, to be fast: where they do not say otherwise, any calibration is judged."""

import contextlib
import dataclasses
from collections.abc import Iterator

from gam_db import Parameters


def judge_any_calibration(least: int = 1) -> None:
    """Let Parameters that say nothing of least_vectors take so many."""
    for one in dataclasses.fields(Parameters):
        one.default = least if one.name == "least_vectors" else one.default
    Parameters.__init__.__defaults__ = tuple(one.default for one in dataclasses.fields(Parameters))


@contextlib.contextmanager
def judging_from(least: int) -> Iterator[None]:
    """Do so for a while."""
    before = Parameters().least_vectors
    judge_any_calibration(least)
    try:
        yield
    finally:
        judge_any_calibration(before)
