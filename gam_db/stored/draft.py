"""A new calibration before readers see it: versions and limits are written together.

This module owns the order of writing: the rows in ``gam_state_version`` come last, after the limits, so
that readers see versions and limits together or not at all.
"""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from typing import Self

from sqlglot import exp

from gam_db.alarms import Alarms
from gam_db.columns import WORD
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.plan import Kind, Plan, Statement
from gam_db.settings.parameters import Parameters
from gam_db.stored.alarms import limits
from gam_db.stored.planning import Row
from gam_db.stored.schema.migration_files import columns_of
from gam_db.stored.state import State
from gam_db.study import Study
from gam_db.study.running import Running

#: What is appended, in this order, before limits and versions; programs where a column says which ran.
TAUGHT = (
    *("calibration", "bounds", "block", "ladder", "probe", "program", "support"),
    *("buffered", "band", "extent", "checksum"),
)

#: In which order it is made. The support first: what reads its cells reads channels in stored order,
#: where they can be; and the sums over all of it last.
_PARTS = (
    "support",
    *(part for part in TAUGHT if part not in ("support", "checksum")),
    "version",
    "checksum",
)


class Draft:
    """A new calibration that readers do not see yet.

    Where there are transactions, it waits in temporary tables for one that writes all of it. Elsewhere
    the rows of a group are appended at once, but for those of versions, without which they are not seen.

    Attributes:
        last: the largest key in use, of each kind, those of the draft included.
    """

    def __init__(self, state: State, keys: dict[str, int]) -> None:
        self.state, self._keys = state, keys
        # A call that was cut short where there are no transactions leaves rows of versions that are not
        # there. Their numbers are not given again.
        begun = max(keys["version"], keys["calibration"], keys["extent"])
        self.last = {**keys, "version": begun}
        self._channels: list[Row] = []
        self._waiting: dict[str, list[exp.Select]] = defaultdict(list)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for rows in self._waiting.values():
            for select in rows:
                self.state.session.forget(select.args["from_"].this)

    def add(self, channels: Sequence[Row], study: Study) -> None:
        """Take what a group of channels was taught: rows of new channels, and the steps of a study."""
        parts = [part for part in _PARTS if f"{part}_rows" in study.steps.steps]
        for part in parts:
            study.prepare(f"{part}_rows")
        running, transactions = study.running, self.state.session.transactions
        waiting = parts if transactions else ["version"]
        tables = {part: Kind.TABLE if part in waiting else Kind.QUERY for part in parts}
        running.execute(_plan(study, tables))
        if transactions:
            self._channels += channels
        else:
            appends = {part: Kind.APPEND for part in TAUGHT if part in parts}
            with self.state.alone(self._keys):
                self.state.append_rows("channel", channels)
                running.execute(_plan(study, appends), target=self.state.tables.table)
        for part in waiting:
            names = study.steps.steps[f"{part}_rows"].query.named_selects
            columns = [exp.column(exp.to_identifier(name)) for name in names]
            self._waiting[part].append(exp.select(*columns).from_(running.release(f"{part}_rows")))

    def publish(self, name: str, alarms: Alarms, parameters: Parameters) -> None:
        """Write what waits, and limits of a monitor for all versions without one, together."""
        if not self._waiting:
            limits.make(self.state, name, alarms, parameters)
            return
        with self.state.alone(self._keys), Running(self.state.session, Pipeline()) as running:
            self.state.append_rows("channel", self._channels)
            self._append(running, TAUGHT)
            running.put("versions", self._versions())
            limits.make(self.state, name, alarms, parameters, versions=running.tables["versions"])
            self._append(running, ["version"])

    def _versions(self) -> exp.Query:
        """Return all versions: those that are there, and the new ones."""
        shown = [
            exp.alias_(exp.cast(exp.column(field.name), "TEXT"), field.name)  # of one collation
            if field.type == WORD
            else exp.column(field.name)
            for field in columns_of("version")
        ]
        new = (rows.args["from_"].this for rows in self._waiting["version"])
        tables = (self.state.tables.table("version"), *new)
        return exp.union(*(exp.select(*shown).from_(table.copy()) for table in tables), distinct=False)

    def _append(self, running: Running, parts: Iterable[str]) -> None:
        waiting = {(part, n): rows for part in parts for n, rows in enumerate(self._waiting[part])}
        statements = [Statement(f"{part}_{n}", Kind.APPEND, part) for part, n in waiting]
        queries = {f"{part}_{n}": rows for (part, n), rows in waiting.items()}
        running.execute(Plan.of(running.steps, statements), queries, self.state.tables.table)


def _plan(study: Study, kinds: Mapping[str, Kind]) -> Plan:
    """Return what becomes of the rows of some parts of a calibration."""
    statements = [Statement(f"{part}_rows", kind, part) for part, kind in kinds.items()]
    return Plan.of(study.steps, statements, study.running.tables)
