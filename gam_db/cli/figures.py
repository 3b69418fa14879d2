"""The figures of a report as one object of JSON, for programs that read on.

This module owns its keys; they are documented by what :func:`figures` returns.
"""

import dataclasses
import datetime as dt
import math
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import gam_db
from gam_db.cli.report import Job, thinned
from gam_db.findings import Finding, need_attention
from gam_db.parameters import Parameters
from gam_db.source import Source

POINTS = 60
"""Points of a course at most."""


def figures(job: Job, found: Sequence[Finding], written: Sequence[str], code: int) -> dict[str, Any]:
    """Return the report as one object that JSON can hold.

    Args:
        job: what was asked.
        found: the findings, in order.
        written: files and tables that were written.
        code: the exit code.
    """
    return {
        **asked(job),
        "channels": [_channel(one) for one in found],
        "verdicts": dict(Counter(one.verdict for one in found)),
        "needs_attention": need_attention(found),
        "written": list(written),
        "exit_code": code,
    }


def asked(job: Job) -> dict[str, Any]:
    """Return what was asked: version, source, settings file, parameters and calibration."""
    source = job.guess.source
    columns = {"asset": source.asset, "time": source.time}
    if isinstance(source, Source):
        columns |= {"channel": source.channel, "value": source.value}
    else:
        columns |= {"channels": list(source.value_columns)}  # type: ignore[dict-item]
    return {
        "version": gam_db.__version__,
        "source": {
            "name": job.name,
            "layout": "long" if isinstance(source, Source) else "wide",
            "columns": columns,
            "guessed": dict(job.guess.guessed),
            "where": source.where,
        },
        "settings_file": job.settings,
        "parameters": _parameters(job.parameters),
        "calibration": plain(_fields(job.calibration)),
    }


def _parameters(parameters: Parameters) -> dict[str, Any]:
    said = _fields(parameters)
    said["overrides"] = [
        {"asset": one.asset, "channel": one.channel, **one.changes()} for one in parameters.overrides
    ]
    return {name: plain(value) for name, value in said.items()}


def _channel(one: Finding) -> dict[str, Any]:
    return plain(  # type: ignore[no-any-return]
        {
            **one.support,
            "status": one.status,
            "needs_attention": one.needs_attention,
            "limit": one.limit,
            "hi_now": one.hi,
            "last_time": one.time,
            "scored_vectors": one.scored,
            "window": one.window,
            "course": thinned(one.course, POINTS),
            "remarks": list(one.remarks),
        }
    )


def _fields(of: Any) -> dict[str, Any]:
    return {one.name: getattr(of, one.name) for one in dataclasses.fields(of)}


def plain(value: Any) -> Any:
    """Return a value in the types of JSON; NaN and infinity are null, times are ISO 8601."""
    if isinstance(value, Mapping):
        return {str(name): plain(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, (dt.date, dt.datetime)):
        return value.isoformat()
    if dataclasses.is_dataclass(value):
        return plain(_fields(value))
    return str(value)
