"""The public call: a source in, curves and choices out.

This module owns what becomes of the other channels where a statement fails: they are asked about alone.
"""

import contextlib
import dataclasses
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.calibration import Calibration
from gam_db.connecting import borrowed
from gam_db.errors import StatementError
from gam_db.guess import sourced
from gam_db.parameters import Parameters
from gam_db.selection.search import Search
from gam_db.selection.select import FAILURES, Selection, alone, selected
from gam_db.source import AnySource, WideSource, parsed_condition
from gam_db.study import Study

Studied = Callable[[AnySource], Study]
"""Makes a study of a source, in a session that is open."""
Studies = Callable[[], AbstractContextManager[Studied]]
"""Opens a session to make studies in, as often as it is asked: an error inside an engine can end one."""


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
        **search: the fields of :class:`gam_db.selection.Search`: tau, tau_by, tau_max, m_max,
            theiler, references, seed, ami_bins.

    Returns:
        Curves and choices. A channel for which nothing can be chosen has a status that says so.

    Raises:
        UserError: see its subclasses; the message says what to mend.
        TypeError: an option that :class:`gam_db.selection.Search` does not have.
    """
    options = Search(**search)
    method = alone(parameters or Parameters(), calibration or Calibration())

    @contextlib.contextmanager
    def studies() -> Iterator[Studied]:
        with borrowed(engine) as session:
            yield lambda given: Study(session, given, *method)

    with borrowed(engine) as session:
        found = sourced(source, session)
    return selected_by_all(studies, found, options)


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
    found, failures = [], []
    for one in channels:
        try:
            with studies() as studied:
                found.append(selected(studied(_only(source, **one)), search))
        except StatementError as error:
            failures.append(one | {"reason": str(error)})
            last = error
    if not found:
        raise last
    tables = {
        field.name: pa.concat_tables(getattr(part, field.name) for part in found)
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
    where = exp.and_(
        parsed_condition(source.where),
        *(
            exp.EQ(this=exp.cast(template.column(name), "TEXT"), expression=template.text(value))
            for name, value in wanted.items()
        ),
    )
    return dataclasses.replace(source, where=where)
