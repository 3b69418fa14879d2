"""Checksums: are frozen calibrations unchanged, and when was the state last checked?

A run verifies the checksums of the versions that it reads whole before it scores with them, and those of
all active versions once a day. This finds damage and slips; who can write the tables can write the sums.

This module owns that, and the record of what was checked.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from sqlglot import exp

from gam_db import data
from gam_db.columns import counts, table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import StateError
from gam_db.method.adding import add
from gam_db.stored.planning import Row
from gam_db.stored.planning.steps import DAY
from gam_db.stored.state import State, now

#: How much was checked: the whole state with its source, or the checksums of the active versions.
STATE, CHECKSUMS = "state", "checksums"

#: Columns of ``sql/stored/calibrating/mismatched.sql`` about that without which nothing can be computed.
_NEEDED = ("intervals_differ", "figures_differ", "range_differs")

_SHOWN = 3


@dataclass(frozen=True)
class Proof:
    """When the state was checked, and what came out.

    Attributes:
        extent: :data:`STATE` or :data:`CHECKSUMS`.
        proved_at: in microseconds since 1970 (UTC).
        channels, versions, buckets: over what.
        differences: that were found.
    """

    extent: str
    proved_at: int
    channels: int
    versions: int
    buckets: int
    differences: int


@cache
def matching_steps() -> Pipeline:
    """Return the steps up to *mismatched*, over the state tables and *wanted* (version_id)."""
    steps = Pipeline(small=frozenset({"frozen", "wanted"}))  # read several times: planned once
    for name in ("frozen", "checksum_rows", "mismatched"):
        add(steps, f"stored/calibrating/{name}")
    return steps


def mismatched(state: State, wanted: exp.Table) -> list[Row]:
    """Return those of the wanted versions that are no longer what calibration froze.

    Returns:
        Rows with version_id; said, what of it differs, in words; is_usable, whether only cells do.
    """
    mismatches = []
    tables = {**state.tables.nodes(), "wanted": wanted}
    for row in state.session.rows(matching_steps().query("mismatched", tables)):
        words = data.table("gam_db.stored.checking", "checks.toml")["frozen"]
        sentence = ", ".join(what for column, what in words.items() if row[column])
        if not row["summed"]:
            sentence = "its bounds or its checksum are not there just once"
        is_usable = row["summed"] and not any(row[name] for name in _NEEDED)
        mismatches.append({"version_id": row["version_id"], "said": sentence, "is_usable": is_usable})
    return mismatches


def verify(state: State, wanted: exp.Table, versions: Sequence[Row]) -> None:
    """Refuse to go on with wanted versions that are no longer what calibration froze; rows name them.

    Raises:
        StateError: what of which channel differs, and what to do.
    """
    rows = mismatched(state, wanted)
    if not rows:
        return
    names = {row["version_id"]: f"{row['asset']} {row['channel']}" for row in versions}
    shown = sorted(f"{names[row['version_id']]!r}: {row['said']}" for row in rows)[:_SHOWN]
    more = f"; and {len(rows) - _SHOWN:,} more" if len(rows) > _SHOWN else ""
    raise StateError(
        f"Frozen calibration in {state.tables}* was changed or damaged, in {len(rows):,} "
        f"channel{'s' * (len(rows) != 1)} ({'; '.join(shown)}{more}). gam does not score with it. "
        "Restore "
        "the tables from a copy of the database, or calibrate anew by `gam calibrate --again`; "
        "`gam check "
        "--state` shows what else differs."
    )


def verify_daily(state: State, monitor: Row) -> bool:
    """Verify all active versions of a monitor, unless that was done within a day; tell whether.

    Raises:
        StateError: see :func:`verify`.
    """
    began = now()
    proofs = last_proofs(state, monitor["monitor_id"])
    times = [
        monitor["created"],
        *(proof.proved_at for proof in proofs.values() if not proof.differences),
    ]
    if any(0 <= began - time < DAY for time in times):
        return False
    rows = state.rows("stored/state/active", {"monitor_id": monitor["monitor_id"]})
    with state.session.lent(table_of(rows, counts("version_id"))) as wanted:
        verify(state, wanted, rows)
    keep(state, monitor["monitor_id"], Proof(CHECKSUMS, began, len(rows), len(rows), 0, 0))
    return True


def keep(state: State, monitor_id: int, proof: Proof) -> None:
    """Record what was checked.

    Raises:
        EngineError: the database cannot be written.
    """
    row = {"monitor_id": monitor_id, **vars(proof)}
    with state.session.transaction():
        state.append_rows("proof", [row])


def last_proofs(state: State, monitor_id: int) -> dict[str, Proof]:
    """Return the newest record of each extent."""
    slots = {"monitor_id": monitor_id, "now": now()}
    return {row["extent"]: Proof(**row) for row in state.rows("stored/checking/last_proofs", slots)}
