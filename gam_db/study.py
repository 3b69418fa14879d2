"""A study: one source, one method, one session; runs the steps and hands out tables.

This module owns the order of work: look, resolve, keep the small steps as temporary tables, compute.
"""

from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
from sqlglot import exp

from gam_db import look, template
from gam_db.calibration import Calibration
from gam_db.engines.duckdb_session import Session
from gam_db.method import Method, pipeline
from gam_db.parameters import Parameters
from gam_db.source import AnySource, is_file, parsed_condition, readings

Listener = Callable[[str], None]


class Study:
    """What is known of a source under one method.

    Args:
        session: an open session; the caller closes it.
        source: where the telemetry lies.
        parameters, calibration: the method.
        on_step: called with the name of each step before it is run.

    Raises:
        UserError: anything of the source, the parameters or the calibration that cannot be used.
    """

    def __init__(
        self,
        session: Session,
        source: AnySource,
        parameters: Parameters,
        calibration: Calibration,
        on_step: Listener = lambda _: None,
    ) -> None:
        self.session = session
        self._on_step = on_step
        self._kept: dict[str, exp.Table] = {}
        relation = session.relation(source.relation)
        columns = session.describe(relation)
        if source.where is not None:
            session.check_condition(relation, parsed_condition(source.where), str(source.where))
        self.source = look.resolved(source, columns, session)
        kind = look.kind_of(self.source, columns, session)
        self.method = Method(
            parameters, calibration, kind, lambda node: session.engine.instant_of(kind, node)
        )
        rows = readings(self.source, relation, lambda node: session.engine.micros_of(kind, node))
        self.steps = pipeline(self.method, rows)
        if is_file(source.relation) and not str(source.relation).lower().endswith((".parquet", ".pq")):
            # Text is parsed once, not once per step.
            self.steps.small |= {"readings"}
        look.check_rows(self._looked())

    def table(self, step: str) -> pa.Table:
        """Return the rows of a step; the small steps before it are kept for the next call."""
        query = self._ready(step)
        self._on_step(step)
        return self.session.fetch(query)

    def put(self, step: str, rows: pa.Table) -> None:
        """Add an Arrow table as a small step that later ones can read."""
        columns = [template.column(name) for name in rows.column_names]
        self.steps.add(step, exp.select(*columns).from_(self.session.relation(rows)))
        self.steps.small |= {step}

    def write(self, step: str, path: Path, table: str) -> None:
        """Write the rows of a step as Parquet, or as a table of a DuckDB file."""
        query = self._ready(step)
        self._on_step(step)
        self.session.write(query, path, table)

    def _ready(self, step: str) -> exp.Query:
        for needed in self.steps.needed([step], self._kept.keys()):
            if needed.name in self.steps.small and needed.name != step:
                self._on_step(needed.name)
                query = self.steps.query(needed.name, self._kept)
                self._kept[needed.name] = self.session.keep(needed.name, query)
        return self.steps.query(step, self._kept)

    def _looked(self) -> pa.Table:
        self._ready("channels")
        return self.session.fetch(self.steps.query("names", self._kept))
