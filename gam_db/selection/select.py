"""The public call of selection: a source in, curves and choices out.

If a statement fails, this module queries each channel alone, so that the others have a result.
"""

import contextlib
import dataclasses
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.arguments import check_names, public
from gam_db.composing import template
from gam_db.engines.connecting import borrowed
from gam_db.errors import StatementError
from gam_db.reading.guess import sourced
from gam_db.selection.budget import add_budget, add_results
from gam_db.selection.lags import add_delays, add_samples
from gam_db.selection.neighbours import MOST_VECTORS, add_dimensions, add_embedding
from gam_db.selection.search import Search
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.setting import settings_of
from gam_db.settings.source import AnySource, WideSource, under
from gam_db.study import Study

Studied = Callable[[AnySource], Study]
"""Makes a study of a source, in a session that is open."""
Studies = Callable[[], AbstractContextManager[Studied]]
"""Opens a session to make studies in, as often as it is asked: an error inside an engine can end one."""

#: What a selection takes beside the fields of a search.
_ARGUMENTS = ("source", "parameters", "calibration", "engine")

FAILURES = pa.schema([("asset", pa.string()), ("channel", pa.string()), ("reason", pa.string())])


@dataclass(frozen=True)
class Selection:
    """The results for each channel (method, section 8). Tables are Arrow, ordered by channel.

    Attributes:
        choices: one row per channel: asset, channel, samples and usable (of calibration); tau, in
            samples, with tau_rule (given, first_minimum, acf_1e, acf_zero, none) and the lags
            ami_minimum, acf_1e, acf_zero of each rule; m_fnn with fnn_status (fnn, noise_floor,
            none), m_cao with cao_status (saturated, no_saturation, stochastic, none); cycle_length
            in samples with window_status (enough, short, no_cycle) and recommended_window in
            vectors, of which calibration has at least eight (NULL where it is too short for any);
            together for this calibration recommended_m and recommended_bins, with the certificate's
            verdict and floor at the bins asked for, recommended_floor at the recommended ones, and
            vectors_needed for those asked for.
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
        dataclasses.replace(calibration, pool=None, reference=()),
    )


def selected(study: Study, search: Search) -> Selection:
    """Run a selection on a study whose method is one of :func:`alone`; its steps are added to it."""
    steps = study.steps
    add_samples(steps, search, study.method.gaps[0])
    extents = study.rows("extents")
    usable = max((extent["usable"] for extent in extents), default=0)
    add_delays(steps, search, max((extent["samples"] for extent in extents), default=0))
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


@public
def select(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
    **search: Any,
) -> Selection:
    """Choose tau, m, B and W for every channel from its calibration (method, section 8).

    Average mutual information (Fraser and Swinney 1986) and autocorrelation give tau, false nearest
    neighbours (Kennel, Brown and Abarbanel 1992) and Cao (1997) give m, the autocorrelation at long
    lags gives the cycle, and the certificate says which m and B the calibration can fill.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: bins, window, max_gap and target_floor are those asked for; m counts where no rule
            finds one, tau not at all. Overrides are left out.
        calibration: the healthy part; default the first fifth of each channel, ``Calibration(
            fraction=1.0)`` for all of it. Pools are left out: each channel speaks for itself.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.
        **search: the fields of :class:`gam_db.selection.search.Search`: tau, tau_by, tau_max, m_max,
            theiler, references, seed, ami_bins.

    Returns:
        Curves and choices. A channel for which nothing can be chosen has a status that says so.

    Raises:
        UserError: see its subclasses; the message says what to correct.
        ArgumentError: an option that :class:`gam_db.selection.search.Search` does not have.
    """
    check_names("select", search, [*_ARGUMENTS, *settings_of(Search)])
    options = Search(**search)
    method = alone(parameters or Parameters(), calibration or Calibration())

    @contextlib.contextmanager
    def studies() -> Iterator[Studied]:
        with borrowed(engine) as session:
            yield lambda relation: Study(session, relation, *method)

    with borrowed(engine) as session:
        resolved = sourced(source, session)
    return selected_by_all(studies, resolved, options)


def selected_by_all(studies: Studies, source: AnySource, search: Search) -> Selection:
    """Run a selection; where the engine refuses a statement, once more for every channel alone.

    ``failures`` names the channels about which a statement was refused again.

    Raises:
        StatementError: nothing could be found of any channel.
    """
    with studies() as studied:
        study = studied(source)
        names = study.table("channels").select(["asset", "channel"])
        channels = names.sort_by([("asset", "ascending"), ("channel", "ascending")]).to_pylist()
        source = dataclasses.replace(study.source, relation=source.relation)
        try:
            return selected(study, search)
        except StatementError:
            if len(channels) < 2:
                raise
    selections, failures = [], []
    for channel in channels:
        try:
            with studies() as studied:
                selections.append(selected(studied(_only(source, **channel)), search))
        except StatementError as error:
            failures.append(channel | {"reason": str(error)})
            last = error
    if not selections:
        raise last
    tables = {
        field.name: pa.concat_tables(getattr(part, field.name) for part in selections)
        for field in dataclasses.fields(Selection)
    }
    return Selection(**tables | {"failures": pa.Table.from_pylist(failures, FAILURES)})


def _only(source: AnySource, asset: str, channel: str) -> AnySource:
    """Return a source of one channel."""
    wanted = {} if source.asset is None else {source.asset: asset}
    if isinstance(source, WideSource):
        source = dataclasses.replace(source, channels=[channel])
    elif source.channel is not None:
        wanted[source.channel] = channel
    return under(
        source,
        *(
            exp.EQ(this=exp.cast(template.column(name), "TEXT"), expression=template.text(value))
            for name, value in wanted.items()
        ),
    )
