"""Sources made for the look, and what is said of them; for the tests of ``gam check``."""

import math
from typing import Any

import numpy as np
import pyarrow as pa

import gam_db
from gam_db import Calibration, Parameters, Source, WideSource
from gam_db.checking import Note, look_at, notes, propose
from gam_db.engines.duckdb.session import DuckSession
from strategies import Row

SHORT = Parameters(window=25)
HALF = Calibration(0.5)
SECOND = 1_000_000


def table(values: Any, times: Any = None, **more: Any) -> pa.Table:
    """A long table of one channel."""
    times = np.arange(len(values)) if times is None else times
    columns = {"time": times, "value": pa.array(values, from_pandas=True), **more}
    columns = {"asset": ["a"] * len(values), "channel": ["x"] * len(values)} | columns
    return pa.table(columns)


def said(
    source: Any, parameters: Parameters = SHORT, calibration: Calibration = HALF
) -> dict[str, Note]:
    """The notes on a source, by subject."""
    source = source if isinstance(source, (Source, WideSource)) else Source(source)
    with DuckSession() as session:
        look = look_at(session, source, parameters, calibration)
    found = notes(look, propose(look))
    assert len({note.subject for note in found}) == len(found)
    for note in found:
        assert "\n" not in note.text
        assert 20 < len(note.text) < 500
    return {note.subject: note for note in found}


def figures(source: Any, **asked: Any) -> dict[str, Any]:
    """The figures of the only channel of a source."""
    source = source if isinstance(source, (Source, WideSource)) else Source(source)
    (row,) = gam_db.check(source, **asked).to_pylist()
    return row  # type: ignore[no-any-return]


def single(rows: list[Row]) -> list[Row]:
    """Leave out what an instant has beyond its first row."""
    return list({row[:3]: row for row in reversed(rows)}.values())


def wave(length: int, period: int = 5) -> Any:
    """A cycle that never repeats a value exactly, nor stands still, and has no finest step."""
    t = np.arange(length)
    return np.sin(t * 2 * math.pi / period) + 1e-3 * np.sin(t * 0.7) + 1e-4 * np.cos(t * 0.11)
