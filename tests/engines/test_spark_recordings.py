"""A real recording on Spark: every figure of reference_counts.csv for it, to the integer."""

from pathlib import Path

import pytest

import engines
from test_recordings import SETTINGS, agrees, counts, series

DATASET = "ur3_cobot"


@pytest.mark.parametrize("setting", SETTINGS, ids="/".join)
def test_reference_counts_on_spark(recordings: Path, setting: tuple[str, ...]) -> None:
    expected = counts(recordings)[DATASET, *setting]
    agrees(engines.session("spark"), series(recordings, DATASET), expected, setting)
