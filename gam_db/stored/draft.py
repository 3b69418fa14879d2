"""What calibration made and nobody sees yet: written as a whole, versions and limits together.

This module owns the order in which that is written: the rows in ``gam_state_version`` come last, after
the limits, so that versions and limits are there together or not at all.
"""

from collections import defaultdict
from collections.abc import Sequence
from typing import Self

from sqlglot import exp

from gam_db.alarms import Alarms
from gam_db.columns import WORD
from gam_db.settings.parameters import Parameters
from gam_db.stored.alarms import limits
from gam_db.stored.planning import Row
from gam_db.stored.schema.migration_files import columns_of
from gam_db.stored.state import State
from gam_db.study import Study

#: What is appended, in this order, before limits and versions; programs where a column says which ran.
TAUGHT = (
    *("calibration", "bounds", "block", "ladder", "probe", "program", "support"),
    *("buffered", "band", "extent", "checksum"),
)

#: In which order it is made. The support first: what reads its cells reads channels in stored order,
#: where they can be; and the sums over all of it last.
_MADE = (
    "support",
    *(part for part in TAUGHT if part not in ("support", "checksum")),
    "version",
    "checksum",
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

    def add(self, channels: Sequence[Row], study: Study) -> None:
        """Take what a group of channels was taught: rows of new channels, and the steps of a study."""
        parts = [part for part in _MADE if f"{part}_rows" in study.steps.steps]
        placed = study.running.placed
        if self.state.session.transactions:
            self._channels += channels
            for part in parts:
                placed[f"{part}_rows"] = self._keep(part, study.query(f"{part}_rows"))
            for part in parts:
                del placed[f"{part}_rows"]
            return
        queries = {part: study.query(f"{part}_rows") for part in parts}
        with self.state.alone(self._keys):
            if channels:
                self.state.append_rows("channel", channels)
            for part in (part for part in TAUGHT if part in queries):
                self.state.append(part, queries[part])
        self._keep("version", queries["version"])

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

    def _keep(self, part: str, query: exp.Query) -> exp.Table:
        names = [exp.column(exp.to_identifier(name)) for name in query.named_selects]
        kept = self.state.session.keep(f"{part}_rows", query)
        self._kept[part].append(exp.select(*names).from_(kept))
        return kept

    def _append(self, part: str) -> None:
        for rows in self._kept[part]:
            self.state.append(part, rows)
