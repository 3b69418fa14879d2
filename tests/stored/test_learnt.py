"""What mutants found untested: what the stored form keeps of calibration, and rows without a time."""

from typing import Any

import duckdb
import pytest

import comparisons
import engines
import gam_db
import harness
import reference
import scripts
from batches import KINDS, history
from gam_db.stored.monitor import Monitor
from visible import put, rows_of

pytestmark = pytest.mark.thorough

BOUNDS = """
    SELECT asset, channel, taught.calibrated_lo, taught.calibrated_hi, calibration_samples,
        taught.calibration_vectors, taught.cells, seen_once, blocks, learnt.verdict, learnt.floor,
        learnt.floor_sd, learnt.floor_max, learnt.finest_bins, learnt.vectors_needed
    FROM gam_state_bounds AS taught JOIN gam_state_version USING (support_id)
    JOIN gam_state_channel USING (channel_id) JOIN gam_state_certified AS learnt USING (version_id)
    ORDER BY asset, channel
"""
SUPPORT = """
    SELECT asset, channel, cell_key, visits, first_block, last_block, first_time, last_time
    FROM gam_state_support JOIN gam_state_version USING (support_id)
    JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel, cell_key
"""
BLOCKS = """
    SELECT asset, channel, block, vectors, novel, first_time, last_time
    FROM gam_state_block JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel, block
"""

Kept = tuple[harness.Answer, harness.Answer, harness.Answer]


def learnt(rows: list[Any], parameters: gam_db.Parameters, calibration: gam_db.Calibration) -> Kept:
    """Return what must be kept of calibration, by the reference."""
    bounds, support, blocks = [], [], []
    summary = reference.support(rows, parameters, calibration)
    pairs = reference.channels(rows, parameters, calibration)
    for said, (channel, pool) in zip(summary, pairs, strict=True):
        name = {"asset": channel.asset, "channel": channel.name}
        vectors = [(member, vector) for member in pool.members for vector in member.learnt]
        cells: dict[int, list[tuple[int, int]]] = {}
        for (member, vector), block in zip(vectors, pool.blocks.tolist(), strict=True):
            seen = cells.setdefault(reference.cell_key(member, vector), [])
            seen.append((block, member.times[vector[0]]))
        figures = ("floor", "floor_sd", "floor_max", "finest_bins", "vectors_needed")
        bounds.append(
            {
                **name,
                "calibrated_lo": said["calibrated_lo"],
                "calibrated_hi": said["calibrated_hi"],
                "calibration_samples": said["calibration_samples"],
                "calibration_vectors": len(vectors),
                "cells": len(cells),
                "seen_once": sum(len(seen) == 1 for seen in cells.values()),
                "blocks": said["blocks"],
                "verdict": said["verdict"],
                **{figure: said[figure] for figure in figures},
            }
        )
        for key, seen in sorted(cells.items()):
            numbers, times = [number for number, _ in seen], [time for _, time in seen]
            row: dict[str, Any] = {"cell_key": key, "visits": len(seen)}
            row |= {"first_block": min(numbers), "last_block": max(numbers)}
            support.append({**name, **row, "first_time": min(times), "last_time": max(times)})
        own = [
            (block, member.times[vector[0]])
            for (member, vector), block in zip(vectors, pool.blocks.tolist(), strict=True)
            if member is channel
        ]
        for block in sorted({number for number, _ in own}):
            times = [time for number, time in own if number == block]
            sizes, novel = reference.left_out(reference.numbered(pool.grid), pool.blocks)
            row = {"block": block, "vectors": int(sizes[block]), "novel": int(novel[block])}
            blocks.append({**name, **row, "first_time": min(times), "last_time": max(times)})
    return bounds, support, blocks


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_kept_of_calibration_is_what_the_reference_learns(kind: str) -> None:
    told = history(kind, 10)  # one in which each kind has something to learn
    method = harness.made(told.parameters, told.calibration)
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
        )
        put(connection, told.final)
        with Monitor(connection, gam_db.Source("telemetry"), *method) as monitor:
            monitor.migrate()
            monitor.calibrate()
        expected = learnt(told.final, *method)
        for name, query, rows in zip(
            ("bounds", "support", "blocks"), (BOUNDS, SUPPORT, BLOCKS), expected, strict=True
        ):
            assert rows
            harness.assert_same(rows, rows_of(connection, query), name)
    comparisons.compared("duckdb", "stored", told.final, *method, told.final)


def test_rows_that_belong_nowhere_count_nowhere(engine: str) -> None:
    """A script cannot refuse rows without a time, an asset or a channel: it leaves them out."""
    rows: list[Any] = [("a", "x", time, float(time % (5 if time < 30 else 7))) for time in range(40)]
    nowhere: list[Any] = [("a", "x", None, 9.0), (None, "x", 3, 9.0), ("a", None, 4, 9.0)]
    method = gam_db.Parameters(m=2, bins=4, window=5), gam_db.Calibration(fraction=0.5)
    session = engines.session(engine)
    table = scripts.telemetry(session, [*rows, *nowhere * 5])
    exact = gam_db.render("exact", engine, gam_db.Source(table.name), *method)
    expected = reference.health_indicator(rows, *method)
    assert len(expected) == 20
    harness.assert_same(expected, scripts.fetched(session, exact))
