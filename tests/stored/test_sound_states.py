"""Nothing false is said of a state in order, whatever has happened to it: histories, then a check."""

import contextlib
import random
from typing import Any

import duckdb
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import gam_db
import harness
from batches import KINDS, history
from gam_db.errors import UserError
from gam_db.stored.checking import Checked
from gam_db.stored.monitor import Monitor
from strategies import Row
from visible import CrashError, crashing, put

#: What a row may change that arrives after calibration was frozen, within the contract.
LATE = {"calibration"}


def lived(kind: str, seed: int) -> tuple[int, Checked, list[dict[str, Any]]]:
    """Let a history happen, with new versions, repairs and pruning in between; check it twice.

    Returns:
        how many buckets are seen, the check of them, and what a check finds after all were counted anew.
    """
    told, chance = history(kind, seed), random.Random(seed)
    parameters, calibration = harness.made(told.parameters, told.calibration)
    reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
        )
        source = gam_db.Source("telemetry")
        monitor = Monitor(connection, source, parameters, calibration, **reach)
        monitor.migrate()
        put(connection, told.first)
        monitor.calibrate(limit=told.limit)
        for number, batch in enumerate(told.batches):
            put(connection, batch.rows)
            for run, step in batch.runs:
                options: dict[str, Any] = {"limit": told.limit}
                if run in ("full", "everything"):
                    options[run] = True
                with contextlib.suppress(CrashError):
                    monitor.score(**options, **({"on_step": crashing(step)} if run == "crash" else {}))
            happen(monitor, chance, told.final[: number + 1])
        first = monitor.checked_state()
        found = connection.execute("SELECT COUNT(*) FROM gam_state_visible_bucket").fetchone()
        assert found is not None
        monitor.score(everything=True)
        return found[0], first, monitor.checked_state().differences.to_pylist()


def happen(monitor: Monitor, chance: random.Random, rows: list[Row]) -> None:
    """Do something else that leaves a state in order."""
    event = chance.choice(["nothing", "nothing", "again", "prune", "repair", "until", "some", "retired"])
    if event == "again":
        monitor.calibrate(again=True)
    elif event == "prune":
        monitor.prune(keep=chance.randrange(40), keep_novel=chance.randrange(40))
    elif event == "retired":
        monitor.prune(keep_versions=0)
    elif event == "repair":
        with contextlib.suppress(UserError):  # where nothing is stored that late
            monitor.score(since=chance.randrange(60))
    elif event == "until":
        with contextlib.suppress(UserError):  # before all that is read of a channel
            monitor.score(until=chance.randrange(20, 60))
    elif event == "some":
        monitor.score(asset=rows[-1][0])


@pytest.mark.full
@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=max(1, settings().max_examples // 50))
@given(seed=st.integers(0, 2**32))
def test_nothing_is_found_in_a_state_in_order(kind: str, seed: int) -> None:
    buckets, first, again = lived(kind, seed)
    assert {row["part"] for row in first.differences.to_pylist()} <= LATE
    assert {row["part"] for row in again} <= LATE
    assert (first.proof.buckets > 0) == (buckets > 0)
