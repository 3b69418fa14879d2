"""What calibration made and nobody sees yet: written as a whole, versions and limits together.

This module owns the order in which that is written: the rows in ``gam_state_version`` come last, after
the limits, so that versions and limits are there together or not at all.
"""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Self

from sqlglot import exp

from gam_db.alarms import Alarms
from gam_db.columns import WORD
from gam_db.settings.parameters import Parameters
from gam_db.stored.alarms import limits
from gam_db.stored.planning import Row
from gam_db.stored.schema.migration_files import columns_of
from gam_db.stored.state import State

#: What is appended, in this order, before limits and versions; programs where a column says which ran.
TAUGHT = (
    *("calibration", "bounds", "block", "ladder", "probe", "program", "support"),
    *("buffered", "band", "extent", "checksum"),
)


class Draft:
    """What calibration made and nobody sees yet.

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
        self._kept: dict[str, list[exp.Select]] = defaultdict(list)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for rows in self._kept.values():
            for one in rows:
                self.state.session.forget(one.args["from_"].this)

    def add(self, channels: Sequence[Row], parts: Mapping[str, exp.Query]) -> None:
        """Take what a group of channels was taught: rows of new channels, and a query for each table."""
        if self.state.session.transactions:
            self._channels += channels
            for part, query in parts.items():
                self._keep(part, query)
            return
        with self.state.alone(self._keys):
            if channels:
                self.state.append_rows("channel", channels)
            for part in (part for part in TAUGHT if part in parts):
                self.state.append(part, parts[part])
        self._keep("version", parts["version"])

    def publish(self, name: str, alarms: Alarms, parameters: Parameters) -> None:
        """Write what waits, and limits of a monitor for all versions without one, together."""
        if not self._kept:
            limits.make(self.state, name, alarms, parameters)
            return
        with self.state.alone(self._keys):
            if self._channels:
                self.state.append_rows("channel", self._channels)
            for part in TAUGHT:
                self._append(part)
            versions = self.state.session.keep("versions", self._versions())
            limits.make(self.state, name, alarms, parameters, versions=versions)
            self.state.session.forget(versions)
            self._append("version")

    def _versions(self) -> exp.Query:
        """Return all versions: those that are there, and the new ones."""
        shown = [
            exp.alias_(exp.cast(exp.column(field.name), "TEXT"), field.name)  # of one collation
            if field.type == WORD
            else exp.column(field.name)
            for field in columns_of("version")
        ]
        new = (rows.args["from_"].this for rows in self._kept["version"])
        tables = (self.state.tables.table("version"), *new)
        return exp.union(*(exp.select(*shown).from_(one.copy()) for one in tables), distinct=False)

    def _keep(self, part: str, query: exp.Query) -> None:
        names = [exp.column(exp.to_identifier(name)) for name in query.named_selects]
        kept = self.state.session.keep(f"{part}_rows", query)
        self._kept[part].append(exp.select(*names).from_(kept))

    def _append(self, part: str) -> None:
        for rows in self._kept[part]:
            self.state.append(part, rows)
