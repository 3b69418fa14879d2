"""Checks before calibration: the properties of a source, what to fix, and which settings to choose.

This folder owns ``gam check``: :mod:`~gam_db.checking.look` runs the formulas of ``sql/check``,
:mod:`~gam_db.checking.notes` says in plain words what they found, :mod:`~gam_db.checking.proposal` what
to set. It learns nothing and writes nothing.
"""

from typing import Any

import pyarrow as pa

from gam_db.arguments import public
from gam_db.checking.look import Look, look_at
from gam_db.checking.notes import Note, must_be_fixed, notes
from gam_db.checking.proposal import Proposal, propose
from gam_db.engines.connecting import borrowed
from gam_db.reading.guess import sourced
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.units import with_units

__all__ = ["Look", "Note", "Proposal", "check", "look_at", "must_be_fixed", "notes", "propose"]


@public
def check(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return what each channel looks like before anything is learnt of it.

    Rows without asset, channel or time are counted, not refused.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: of the method; default :class:`~gam_db.Parameters`.
        calibration: the healthy part, of which the samples are counted; default the first fifth.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.

    Returns:
        One row per (asset, channel) pair, ordered: asset, channel, readings (rows of the source),
        without_time (of these), samples (distinct instants), repeated (further rows of an instant),
        conflicts (instants with different values), missing (samples); first_tick, last_tick (integer
        microseconds or counter), first_time, last_time (the same as the source tells time);
        typical_step (lower median), short_step, long_step (5 and 95 %), typical_steps (how many are
        just that), pauses (steps beyond five typical ones), longest_step (that is none),
        shortest_pause, longest_pause, all in microseconds or counter steps; lowest, highest (of the
        values); rises, falls, stills (samples above, below, equal to the one before), longest_still
        (samples of one value in a row); values_seen and quantum (distinct values, and their smallest
        difference, among at most 20,480 samples); cycle_length (samples) and cycle_strength (its
        autocorrelation), NULL where no cycle was found in the first 163,840 samples;
        calibration_samples, calibration_lowest, calibration_highest; still_after (as it is
        set, else as it would be proposed), calibration_still (samples of calibration that count as
        still by it), still_runs, longest_run (of these, and the samples of the longest); notes
        (what is to be known of the channel and of the source as a whole, in sentences, what must be
        fixed first). What a row lacks is NULL. Units stand in the metadata of its schema
        (:mod:`gam_db.units`).

    Raises:
        UserError: the source, a parameter or the calibration cannot be used at all.
    """
    with borrowed(engine) as session:
        method = parameters or Parameters(), calibration or Calibration()
        look = look_at(session, sourced(source, session), *method)
    source_notes = notes(look, propose(look))
    texts = [
        [
            note.text
            for note in source_notes
            if not note.channels or (row["asset"], row["channel"]) in note.channels
        ]
        for row in look.table.select(["asset", "channel"]).to_pylist()
    ]
    table = look.table.append_column("notes", pa.array(texts, pa.list_(pa.string())))
    return with_units(table, look.kind)
