"""Engines: flat data and small rewrites, one file per engine.

Nothing outside this folder asks which engine it is. What is known of an engine at work is in
``evidence.csv``, which the tests hold to what they run.
"""

import importlib

from gam_db.engines.base import Engine
from gam_db.engines.evidence import evidence
from gam_db.errors import EngineError, nearest

NAMES = tuple(evidence())


def engine_named(name: str) -> Engine:
    """Return the engine of that name.

    Raises:
        EngineError: there is none; the message suggests the nearest.
    """
    if name not in NAMES:
        raise EngineError(f"There is no engine {name!r}{nearest(name, NAMES)}.")
    engine = importlib.import_module(f"gam_db.engines.{name}").ENGINE
    assert isinstance(engine, Engine)
    return engine
