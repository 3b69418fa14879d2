"""The state tables: their names, and where they lie.

This module owns the names; the files in ``migrations/`` own what the tables hold. What people and other
tools read is called ``<prefix>fleet`` and so on, what only gam-db uses ``<prefix>state_run``.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

from sqlglot import exp

from gam_db.composing import template
from gam_db.errors import ConfigurationError, InternalError

TABLES = (
    *("migration", "monitor", "channel", "version", "calibration", "bounds", "block", "probe"),
    *(
        "program",
        "support",
        "bucket",
        "novel",
        "unknown_program",
        "run",
        "unplaced",
        "checksum",
        "horizon",
        "proof",
        "ladder",
    ),
    *("buffered", "extent", "limit", "judgement", "episode", "label", "band", "band_visit", "move"),
    "left_out",
)
#: Each after those that it reads.
VIEWS = (
    *("finished_run", "hidden_run", "visible_bucket", "visible_novel", "visible_program"),
    *("visible_judgement", "visible_episode"),
    *("labelled_episode", "certified", "health", "stillness", "onset", "fleet", "machine", "trend"),
    *("unplaced_day", "last_run", "cell", "unjudged_program", "quarantine", "growth"),
    *("alarm", "alarm_event", "alarm_band", "alarm_cell"),
)

#: What people and other tools read or write. All else is of gam-db alone.
FOR_READERS = frozenset(
    {
        *(
            "fleet",
            "machine",
            "health",
            "stillness",
            "onset",
            "trend",
            "unplaced_day",
            "last_run",
            "ladder",
            "probe",
        ),
        *("program", "cell", "unjudged_program", "quarantine", "growth"),
        *("alarm", "alarm_event", "alarm_band", "alarm_cell", "visible_judgement", "label"),
    }
)

_PREFIX = re.compile(r"([A-Za-z_][A-Za-z0-9_]{0,39})?")


@dataclass(frozen=True)
class StateTables:
    """The schema and prefix of the state; a database may have several states.

    Attributes:
        schema: the schema that holds them; None for the current one of the connection.
        prefix: begins each name: letters, digits and underscores, at most 40, no digit first. It may be
            empty in a schema.
        apart: stands between the prefix and the name of what only gam-db uses.

    Raises:
        ConfigurationError: the schema or prefix is no such name.
    """

    schema: str | None = None
    prefix: str = "gam_"
    apart: str = "state_"

    def __post_init__(self) -> None:
        if self.schema is not None and (not isinstance(self.schema, str) or not self.schema):
            raise ConfigurationError(f"schema is {self.schema!r}; it takes the name of a schema.")
        if not isinstance(self.prefix, str) or not _PREFIX.fullmatch(self.prefix):
            raise ConfigurationError(
                f"prefix is {self.prefix!r}; it takes letters, digits and underscores, at most 40, and "
                "does not begin with a digit."
            )
        if not self.prefix and self.schema is None:
            raise ConfigurationError("prefix is empty; without a prefix, give a schema.")

    def __str__(self) -> str:
        return self.prefix if self.schema is None else f"{self.schema}.{self.prefix}"

    def table(self, name: str) -> exp.Table:
        """Return the node of a table or view, ``"run"`` for ``<schema>.<prefix>state_run``."""
        if name not in (*TABLES, *VIEWS):
            raise InternalError(f"There is no state table {name!r}.")
        db = None if self.schema is None else template.name(self.schema)
        return exp.Table(this=template.name(self._called(name)), db=db)

    def shown(self, name: str) -> str:
        """Return the name of a table or view as messages show it."""
        called = self._called(name)
        return called if self.schema is None else f"{self.schema}.{called}"

    def folded(self, name: str) -> str:
        """Return the name of a table or view in lower case, to look it up among others."""
        return self._called(name).casefold()

    def nodes(self) -> dict[str, exp.Table]:
        """Return what the SQL calls the tables (``stored_run``), each with the node that it means."""
        return dict(_nodes(self))

    def _called(self, name: str) -> str:
        return f"{self.prefix}{'' if name in FOR_READERS else self.apart}{name}"


@lru_cache(maxsize=64)
def _nodes(tables: StateTables) -> Mapping[str, exp.Table]:
    return {f"stored_{name}": tables.table(name) for name in (*TABLES, *VIEWS)}
