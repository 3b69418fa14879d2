"""A whole recording on PostgreSQL: every figure of reference_counts.csv, to the integer."""

from pathlib import Path

import pyarrow.parquet as pq
import pytest

import engines
import gam_db
from test_recordings import SETTINGS, agrees, counts


@pytest.mark.parametrize("setting", SETTINGS, ids="/".join)
def test_reference_counts_of_the_cobot(recordings: Path, setting: tuple[str, ...]) -> None:
    session = engines.session("postgres")
    rows = pq.read_table(recordings / "ur3_cobot" / "series.parquet")
    with session.lent(rows) as table:
        source = gam_db.Source(table.name, time="ts")
        agrees(session, source, counts(recordings)["ur3_cobot", *setting], setting)
