"""Changing a table of files: the rows that it is to have are written to another place."""

import secrets
from collections.abc import Callable, Sequence
from typing import Any

from sqlglot import exp

from gam_db import template
from gam_db.engines.base import Engine


class Rewriting:
    """What tables have in common, wherever a session of Spark keeps them."""

    def __init__(self, session: Any, run: Callable[[str], Any], engine: Engine) -> None:
        self._session, self._run, self._engine = session, run, engine

    def _do(self, tree: exp.Expr) -> Any:
        return self._run(self._engine.text(tree))

    def _columns(self, table: exp.Table) -> tuple[str, ...]:
        return tuple(self._session.table(table.sql(dialect="spark")).columns)

    def staying(
        self, table: exp.Table, columns: Sequence[str], keys: Sequence[str], found: exp.Query
    ) -> exp.Query | None:
        """Return the rows of a table that stay; None if none are to go, whose keys are found."""
        same = same_keys(keys)
        rows = exp.select(*(exp.column(template.name(name), table="staying") for name in columns))
        rows = rows.from_(table.copy().as_("staying"))
        doomed = exp.Subquery(this=found.copy(), alias=exp.TableAlias(this=exp.to_identifier("gone")))
        any_row = rows.join(doomed.copy(), on=same.copy(), join_type="left semi").limit(1)
        if self._do(any_row).isEmpty():
            return None
        return rows.join(doomed, on=same, join_type="left anti")

    def write_beside(
        self, table: exp.Table, columns: Sequence[str], rows: exp.Query, place: str
    ) -> None:
        """Write rows that a table is to have to a folder that is not there yet."""
        beside = table.copy()
        beside.set("this", template.name(f"{table.name}_{secrets.token_hex(4)}"))
        placed = [exp.LikeProperty(this=table.copy()), exp.LocationProperty(this=template.text(place))]
        properties = exp.Properties(expressions=placed)
        self._do(exp.Create(this=beside, kind="TABLE", properties=properties))
        names = [template.name(name) for name in columns]
        self._do(exp.Insert(this=exp.Schema(this=beside.copy(), expressions=names), expression=rows))
        self._do(exp.Drop(tables=[beside.copy()], kind="TABLE"))


def same_keys(keys: Sequence[str]) -> exp.Expr:
    """Return the condition that a row of *staying* has the keys of one of *gone*."""
    return exp.and_(
        *(
            exp.column(template.name(key), table="staying").eq(
                exp.column(template.name(key), table="gone")
            )
            for key in keys
        )
    )
