"""Redshift: PostgreSQL's older relative, with DATEDIFF."""

from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.engines.postgres import ENGINE as POSTGRES
from gam_db.engines.storage import Definition, Storage


def _sorted(definition: Definition) -> list[exp.Expr]:
    """Return that a table is sorted by its key."""
    return [exp.SortKeyProperty(this=[column.this for column in definition.key], compound=True)]


_STORAGE = Storage(properties=_sorted)
ENGINE = Engine.named("redshift", instant=POSTGRES.instant, storage=_STORAGE)
