"""A study: one source, one method, one session; runs the steps and hands out tables.

This module owns the order of work: look at the source, resolve what was asked, make the steps.
"""

import dataclasses
from functools import lru_cache
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import look, streaming, template
from gam_db.bits import Bits
from gam_db.calibration import Calibration
from gam_db.engines.base import Engine
from gam_db.engines.session import Session
from gam_db.method import Method, pipeline
from gam_db.parameters import Parameters
from gam_db.pipeline import Pipeline
from gam_db.running import Listener, Running, unheard
from gam_db.source import AnySource, is_file, parsed_condition, readings
from gam_db.streaming import Streams, seems_ordered

#: Studies whose filled and composed steps are kept; each has a few thousand nodes of trees.
LATELY = 16


class Study:
    """What is known of a source under one method.

    Args:
        session: an open session; the caller closes it.
        source: where the telemetry lies.
        parameters, calibration: the method.
        on_step: called with the name of each step before it is run.
        strict: refuse a source with rows that belong nowhere; else the step *names* counts them, and
            they are left out of all that follows.
        streams: read channels that are stored in order of time in that order
            (:mod:`gam_db.streaming`); not for who changes what the steps read.

    Raises:
        UserError: anything of the source, the parameters or the calibration that cannot be used.
    """

    def __init__(
        self,
        session: Session,
        source: AnySource,
        parameters: Parameters,
        calibration: Calibration,
        on_step: Listener = unheard,
        strict: bool = True,
        streams: bool = False,
    ) -> None:
        self.session, self._named = session, source.relation
        self._is_lent = not isinstance(source.relation, (str, Path, tuple, list))
        self.relation = relation = session.relation(source.relation)
        self.columns = columns = session.describe(relation)
        if source.where is not None:
            session.check_condition(relation, parsed_condition(source.where), str(source.where))
        self.source = look.resolved(source, columns, session)
        kind = look.kind_of(self.source, columns, session)
        self.method = Method(parameters, calibration, kind)
        unread = dataclasses.replace(self.source, relation=None)  # the node counts
        asked = (self.method, unread, relation, session.engine)
        bits = session.engine.bits
        steps = self._steps(*asked) if bits is None else self._steps(*asked, streaming.GLANCE)
        self.running = Running(session, steps, on_step=on_step)
        is_tried = streams and seems_ordered(self.method, self.running)
        self._streams = Streams(self.method, self.running) if is_tried else None
        names = self._looked()
        (look.check_rows if strict else look.check_clock)(names)
        has_room = bits is not None and self._has_room(bits, names.num_rows)
        if self._streams is not None and not (has_room and self._streams.serve()):
            self._streams = None
        if bits is not None and not has_room:
            self.running.steps = self._steps(*asked)

    @property
    def steps(self) -> Pipeline:
        """The steps of the study."""
        return self.running.steps

    @property
    def is_streamed(self) -> bool:
        """Tell whether vectors were made of channels as they are stored."""
        return self._streams is not None and self._streams.holds and self._streams.has_begun

    def table(self, step: str) -> pa.Table:
        """Return the rows of a step; the small steps before it are kept for the next call."""
        self._prepare(step)
        return self.running.table(step)

    def put(self, step: str, rows: pa.Table) -> None:
        """Add an Arrow table as a small step that later ones can read."""
        columns = [template.column(name) for name in rows.column_names]
        self.steps.add(step, exp.select(*columns).from_(self.session.relation(rows)))
        self.steps.small |= {step}

    def write(self, step: str, path: Path, table: str) -> None:
        """Write the rows of a step as Parquet, or as a table of a DuckDB file."""
        self._prepare(step)
        self.running.write(step, path, table)

    def instant_of(self, time: exp.Expr) -> exp.Expr:
        """Return integer time as the source has it."""
        return self.session.engine.instant_of(self.method.kind, time)

    def forget(self) -> None:
        """Drop the tables that were kept, and let go of an Arrow table: the session stays open."""
        self.running.forget()
        if self._is_lent and isinstance(self.relation, exp.Table):
            self.session.forget(self.relation)

    def _steps(self, *asked: Any) -> Pipeline:
        """Return steps of the study's own; text is parsed once, not once per step."""
        steps = _filled(*asked).copied()
        path = str(self._named).lower()
        if is_file(self._named) and not path.endswith((".parquet", ".pq")):
            steps.small |= {"readings"}
        return steps

    def _has_room(self, bits: Bits, channels: int) -> bool:
        """Tell whether the supports of so many channels may be kept as bits."""
        grids = (setting.radix**setting.m for setting in self.method.settings)
        return all(bits.serve(cells, channels) for cells in grids)

    def _prepare(self, step: str) -> None:
        if self._streams is not None:
            self._streams.prepare(step)

    def _looked(self) -> pa.Table:
        self.running.keep("names")
        return self.session.fetch(self.steps.query("names", self.running.placed))


@lru_cache(maxsize=LATELY)
def _filled(
    method: Method, source: AnySource, relation: exp.Expr, engine: Engine, glance: int = 0
) -> Pipeline:
    """Return the steps of a method, which nobody may add to; asked again, the same ones.

    Args:
        method: what the user asked for.
        source: how the relation is read; its own relation does not matter.
        relation: the node to read from.
        engine: knows the way from the source's time to integers, and back.
        glance: keep supports as bits, as the engine does it, and look at so many rows first; 0: do not.
    """
    kind, bits = method.kind, engine.bits if glance else None
    rows = readings(source, relation, lambda node: engine.micros_of(kind, node))
    return pipeline(method, rows, lambda node: engine.instant_of(kind, node), bits, glance)
