"""What ``gam run`` prints, called from Python."""

import dataclasses
from typing import Any

from gam_db.alarms import Alarms
from gam_db.arguments import public
from gam_db.checking.look import exact_columns
from gam_db.cli.job import Job
from gam_db.cli.once import Summary, summarised
from gam_db.engines.connecting import borrowed
from gam_db.reading.guess import looked_up
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source, WideSource, is_file, shown_relation
from gam_db.stored.lengths import park_after
from gam_db.study import Study


@public
def summary(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    engine: Any = None,
) -> Summary:
    """Return what ``gam run`` prints: of each channel its verdict, what it sees, its course and remarks.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: of the method; default :class:`gam_db.Parameters`.
        calibration: the healthy part; default the first fifth of each channel.
        alarms: the asked rate and the families; default :class:`gam_db.Alarms`.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open connection.

    Returns:
        ``print(summary)`` prints the page; ``summary.channels`` are its rows, and
        ``summary.needs_attention`` says whether one needs attention. See :class:`gam_db.Summary`.

    Raises:
        UserError: see its subclasses; the message says what to mend.
    """
    method = parameters or Parameters(), calibration or Calibration()
    with borrowed(engine) as session:
        seen = looked_up(source, session)
        study = Study(session, seen.source, *method, short_cuts=True)
        try:
            job = Job(
                _name(source.relation if isinstance(source, (Source, WideSource)) else source),
                dataclasses.replace(seen, source=study.source),
                *method,
                exact=exact_columns(session, study.source, study.columns),
            )
            longest = park_after(None, study.method.kind)
            return summarised(study, job, alarms or Alarms(), longest)
        finally:
            if session is engine:  # it stays open
                study.forget()


def _name(relation: Any) -> str:
    """Return what a source is called: a table or file by its name, all else by what it is."""
    is_named = isinstance(relation, (str, tuple)) or is_file(relation)
    return shown_relation(relation) if is_named else type(relation).__name__
