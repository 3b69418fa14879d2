"""One selection: a study in, curves and choices out."""

import dataclasses
from dataclasses import dataclass, field

import pyarrow as pa

from gam_db.calibration import Calibration
from gam_db.parameters import Parameters
from gam_db.selection.budget import add_budget, add_results
from gam_db.selection.lags import add_delays, add_samples
from gam_db.selection.neighbours import MOST_VECTORS, add_dimensions, add_embedding
from gam_db.selection.search import Search
from gam_db.study import Study

FAILURES = pa.schema([("asset", pa.string()), ("channel", pa.string()), ("reason", pa.string())])


@dataclass(frozen=True)
class Selection:
    """What was found for each channel (method, section 8). Tables are Arrow, ordered by channel.

    Attributes:
        choices: one row per channel: asset, channel, samples and usable (of calibration); tau, in
            samples, with tau_rule (given, first_minimum, acf_1e, acf_zero, none) and the lags
            ami_minimum, acf_1e, acf_zero of each rule; m_fnn with fnn_status (fnn, noise_floor,
            none), m_cao with cao_status (saturated, no_saturation, stochastic, none); cycle_length
            in samples with window_status (enough, short, no_cycle) and recommended_window in
            vectors; together for this calibration recommended_m and recommended_bins, with the
            certificate's verdict and floor at the bins asked for, recommended_floor at the
            recommended ones, and vectors_needed for those asked for.
        lags: one row per delay from 0: n_pairs, occupied (pairs of bins), ami and ami_corrected in
            nats, acf, informative (1 if the information is more than chance). Beyond 2^17 samples
            about so many, spread evenly, are paired with those a delay later, here and in cycles.
        dimensions: one row per embedding dimension m: reference_vectors, neighbours, skipped (found
            beyond others at distance zero), false_neighbours, false_share, Cao's e1 and e2. Beyond
            2^15 samples about so many vectors, spread evenly, take part.
        cycles: one row per delay of each scale of the autocorrelation: scale and delay in
            samples, n_pairs, acf.
        budget: one row per embedding dimension m: vectors, cells, floor, verdict, finest_bins (the
            finest grid that passes) with finest_floor, vectors_needed.
        failures: one row per channel that the engine could not be asked about: asset, channel, reason.
            The other tables have none of it.
    """

    choices: pa.Table
    lags: pa.Table
    dimensions: pa.Table
    cycles: pa.Table
    budget: pa.Table
    failures: pa.Table = field(default_factory=FAILURES.empty_table)


def alone(parameters: Parameters, calibration: Calibration) -> tuple[Parameters, Calibration]:
    """Return the method for channels that each speak for themselves: one set of numbers, no pools."""
    return (
        dataclasses.replace(parameters.finest(), overrides=()),
        dataclasses.replace(calibration, pool=None),
    )


def selected(study: Study, search: Search) -> Selection:
    """Run a selection on a study whose method is one of :func:`alone`; its steps are added to it."""
    steps = study.steps
    add_samples(steps, search)
    extents = study.rows("extents")
    usable = max((one["usable"] for one in extents), default=0)
    add_delays(steps, search, max((one["samples"] for one in extents), default=0))
    add_embedding(steps, search, study.method.settings[0].grid)

    def waiting(step: str) -> tuple[int, int]:
        (row,) = study.rows(step)
        return row["vectors"], row["waiting"]

    add_dimensions(steps, search, min(usable, MOST_VECTORS), waiting)
    add_budget(steps, study.method, search)
    add_results(steps, study.method)
    return Selection(
        choices=study.table("choices"),
        lags=study.table("lag_curve"),
        dimensions=study.table("dimension_curve"),
        cycles=study.table("cycle_curve"),
        budget=study.table("budget_curve"),
    )
