"""The exact form: from a source to its health indicator, support and certificate; it stores nothing.

This module owns the public calls of that form.
"""

from typing import Any

import pyarrow as pa

from gam_db.arguments import public
from gam_db.errors import wrong
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.study import studied
from gam_db.units import with_units


@public
def health_indicator(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the health indicator at every scored vector (paper, Eq. 1 to 4).

    Args:
        source: the telemetry: a :class:`Source` or :class:`WideSource`, or a relation that these accept
            (a path, a list of paths, a table, a data frame), whose columns gam-db guesses like the
            command line; also polars' LazyFrame, a relation of DuckDB, a table of Ibis. A single signal
            may be a 1-D array of NumPy, whose readings have the times 0, 1, 2, ..., or a series of
            pandas, whose index (a DatetimeIndex or whole numbers) is the time; the name of the series,
            else ``value``, is the name of its channel.
        parameters: of the method; default :class:`Parameters`.
        calibration: the healthy part; default the first fifth of each channel.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.

    Returns:
        The metadata of the schema hold the units (:mod:`gam_db.units`).

        One row per scored vector, ordered by asset, channel and time: asset, channel, time (as in the
        source), cell_key, novel (0 or 1), out_of_range (1 if a coordinate lies outside the calibrated
        range), straddling (1 if one of its samples is one of calibration), novel_in_window,
        vectors_in_window (both counts), hi (their ratio, NULL until the window is full).

    Raises:
        UserError: see its subclasses; the message says what to correct.
    """
    return _table("health_indicator", source, parameters, calibration, engine)


@public
def health_at_buckets(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the health indicator at the end of every full bucket of ``stride`` scored vectors.

    Arguments, errors and integers are those of :func:`health_indicator`.

    Returns:
        One row per bucket, ordered: asset, channel, bucket (from 0), first_time, last_time, novel and
        out_of_range (counts), novel_in_window, hi (both NULL until the window is full).
    """
    return _table("bucket_health", source, parameters, calibration, engine)


@public
def support(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the calibration of each channel and a summary of its certificate (method, section 5).

    Arguments and errors as in :func:`health_indicator`.

    Returns:
        One row per channel, ordered: asset, channel, calibrated_lo, calibrated_hi, dropped_below,
        dropped_above (calibration samples left out of that range), lowest_dropped, highest_dropped
        (the farthest of them, NULL where there are none), samples, calibration_samples,
        calibration_vectors, cells, missing_vectors, conflicts, verdict (no_data, constant, ready,
        blind, too_fine, needs_data or not_vouched), floor, floor_sd, floor_max (shares), good_turing,
        cells_per_vector, blocks, finest_bins (the finest grid that passes), vectors_needed (further
        calibration vectors, 0 if it passes, NULL if no figure can be given), usual_low, usual_middle,
        usual_high (one in twenty calibration values lies below, the middle one, one in twenty above),
        sees (the smallest of the shifts of 1, 2, 5, 10, 20 and 50 % of that range that would lift the
        indicator above its limit both ways; NULL if none), sees_half_stroke, sees_frozen, sees_faster,
        sees_slower (1 or 0, NULL if it could not be tried), would_not_see (in words), blind_reason
        (range, blocks, cells or delay, where the verdict is blind: no shift is seen), vouched_by (how
        many machines of its pool vouch for one that taught nothing, NULL of others), taught_by (the
        machines that taught its pool, in words), member_floor (the floor by leaving one of them out,
        NULL where less than two taught; both sides, section 6), hi_limit (the
        health indicator above which the channel is high, NULL where nothing is to be judged),
        limit_reason (why there is none).
    """
    return _table("support_summary", source, parameters, calibration, engine)


@public
def probe(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return, for each channel, what the indicator would show if its machine changed.

    It changes up to 1,000 vectors of calibration and looks them up in the support like those of a
    healthy block: a cell that no other block visited is novel (both sides, section 2). Arguments and
    errors as in :func:`health_indicator`.

    Returns:
        19 rows per channel that calibration teaches, ordered: asset, channel, change_name (shift +1 % to
        shift -50 %, of the width between the values below and above which one in twenty lies; stroke
        0.5, 0.8 and 1.2, times as far from the middle; frozen; speed 3/2, 2/1 and 2/3, times as fast),
        vectors (NULL where two delays would be one), novel (of them).
    """
    return _table("probes", source, parameters, calibration, engine)


@public
def programs(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the programs that each machine ran in calibration and since (both sides, section 5).

    The source names the column of programs (``program``). Arguments and errors as in
    :func:`health_indicator`.

    Returns:
        One row per channel and program, ordered: asset, channel, program (as text; NULL for readings
        without one), verdict (ready, needs_data or unknown: vectors of the last two are not judged),
        vectors (of calibration), unvouched (of these, how many only their own block vouches for), floor
        (their share), readings, first_time, last_time (since calibration, missing ones left out).
        Figures of calibration are those of the pool.

    Raises:
        SourceError: the source names no program column.
    """
    if getattr(source, "program", None) is None:
        raise wrong("no_program_column")
    return _table("program_summary", source, parameters, calibration, engine)


@public
def certificate(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the certificate of each channel, block by block (method, section 5).

    Arguments and errors as in :func:`health_indicator`.

    Returns:
        One row per block, ordered: asset, channel, block (from 0), first_time, last_time, vectors and
        novel (its vectors in cells no other block visited), healthy_hi (their ratio), and the learning
        curve had calibration ended here: learned_vectors, learned_cells, learned_floor.
    """
    return _table("certificate", source, parameters, calibration, engine)


def _table(
    step: str, source: Any, parameters: Parameters | None, calibration: Calibration | None, engine: Any
) -> pa.Table:
    with studied(source, parameters, calibration, engine, short_cuts=True, targets=[step]) as study:
        return with_units(study.table(step), study.method.kind)
