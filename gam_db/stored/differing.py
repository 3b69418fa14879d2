"""Differing: which channels were calibrated under other settings than those that are set now.

This module owns the comparison. It reads state tables only, never the source.
"""

import pyarrow as pa

from gam_db.calibration import Calibration
from gam_db.method import Method
from gam_db.method.source import add_source
from gam_db.parameters import Parameters
from gam_db.pipeline import Pipeline
from gam_db.stored.calibrating import settings_hash
from gam_db.stored.state import State, kind_of


def differing(
    state: State, name: str, parameters: Parameters, calibration: Calibration
) -> list[tuple[str, str]]:
    """Return asset and channel of the active versions that were made under other settings.

    Args:
        state: the state tables.
        name: of the monitor.
        parameters: what is set now.
        calibration: likewise.

    Raises:
        UserError: there is no such monitor, or a length does not fit how it tells time.
    """
    monitor = state.monitor(name)
    method = Method(parameters.finest(), calibration, kind_of(monitor), parameters)
    versions = state.fetch("stored/active", {"monitor_id": monitor["monitor_id"]})
    rows = versions.to_pylist()
    names = pa.table(
        {
            **{role: versions[role] for role in ("asset", "channel")},
            "readings": pa.array([1] * len(rows), pa.int64()),
            "missing_readings": pa.array([0] * len(rows), pa.int64()),
        }
    )
    steps = Pipeline()
    add_source(steps, method)
    with state.session.lent(names) as lent:
        chosen = state.session.rows(steps.query("channels", {"names": lent}))
    wanted = {(row["asset"], row["channel"]): settings_hash(method, row) for row in chosen}
    made = {(row["asset"], row["channel"]): row["settings_hash"] for row in rows}
    return sorted(channel for channel, hashed in made.items() if wanted[channel] != hashed)
