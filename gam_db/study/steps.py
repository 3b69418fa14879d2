"""The steps of studies, filled once: a copy of trees costs more than most questions over few rows."""

from functools import lru_cache

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.base import Engine
from gam_db.method import Method, opening_pipeline, pipeline, trusting_pipeline
from gam_db.method.census import Slicing
from gam_db.method.delays import Ways
from gam_db.settings.source import AnySource

#: Studies whose filled and composed steps are kept; each has a few thousand nodes of trees.
LATELY = 16

#: Ranges of time that a study asks for.
RANGES = 3


@lru_cache(maxsize=LATELY)
def opened(
    method: Method,
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    until: int | None,
    slicing: Slicing | None,
    ways: Ways | None,
) -> Pipeline:
    """Return the steps that are asked first, likewise; arguments as for :func:`filled`."""
    rows = engine.readings(source, relation, method.kind, until=until)
    return opening_pipeline(rows, slicing, ways)


@lru_cache(maxsize=RANGES * LATELY)
def ranged(
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    kind: TimeKind,
    earliest: int,
    latest: int,
    until: int | None,
) -> exp.Query:
    """Return the step *readings* for a range of time; arguments as for :func:`filled`."""
    return engine.readings(source, relation, kind, earliest, latest, until=until)


@lru_cache(maxsize=LATELY)
def filled(
    method: Method,
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    until: int | None,
    has_bits: bool,
    slicing: Slicing | None = None,
    ways: Ways | None = None,
) -> Pipeline:
    """Return the steps of a method, read-only; the same ones at every call.

    The relation is the node to read from; that of the source does not matter. Slicing and ways are for
    the steps that trust; without slicing they look first.
    """
    kind, bits = method.kind, engine.bits if has_bits else None
    rows = engine.readings(source, relation, kind, until=until)
    arguments = method, rows, lambda node: engine.instant_of(kind, node)
    if slicing is not None:
        return trusting_pipeline(*arguments, slicing, bits, ways)
    return pipeline(*arguments, bits)
