"""Versions and limits come together: what a calibration that dies leaves is mended by the next one."""

import functools
from typing import Any

import pytest
from sqlglot import exp

import engines
import scripts
from gam_db.composing.plan import insertion
from gam_db.engines.session import Session
from gam_db.stored import state
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import TABLES
from gam_db.study import running
from small_plant import FIRST, LENGTH, monitor, readings
from visible import BUCKETS, NOVEL, CrashError, visible

#: Before what the process dies: what channels learnt, what limits are made of, limits, versions.
MOMENTS = ("support", "checksum", "limit", "version")

#: Readings that are worked on at once: two channels.
GROUP = 2 * FIRST

LIMITS = """
    SELECT asset, version_no, limit_no, from_judgement, cause, blocks, reference, height, basis,
        gam_state_limit.reason
    FROM gam_state_limit JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, version_no, limit_no
"""


def made(session: Session, prefix: str = "") -> Monitor:
    table = scripts.telemetry(session, readings(0, FIRST))
    begun = monitor(session, table.name, prefix or engines.fresh_name("state"))
    begun.migrate()
    return begun


def rows_of(begun: Monitor) -> dict[str, Any]:
    """Return how many rows each table has."""
    counts = exp.select(exp.Count(this=exp.Star()).as_("rows"))
    return {
        name: begun.session.rows(counts.copy().from_(begun.state.tables.table(name)))[0]["rows"]
        for name in TABLES
        if name not in ("migration", "monitor")
    }


def dying(monkeypatch: pytest.MonkeyPatch, at: str) -> None:
    """Let a process die before it appends to a table for the last time."""

    def dies(table: exp.Table, rows: exp.Query) -> exp.Insert:
        if table.name.endswith(f"_{at}"):
            raise CrashError
        return insertion(table, rows)

    for module in (running, state):  # by a list, and row by row
        monkeypatch.setattr(module, "insertion", dies)


def finished(begun: Monitor) -> list[Any]:
    scripts.arrive(begun.session, exp.to_table(str(begun.source.relation)), readings(FIRST, LENGTH))
    begun.score()
    seen = [visible(begun, query) for query in (BUCKETS, NOVEL, LIMITS)]
    alarms = begun.limits().select(["asset", "limit_no", "cause", "reference", "height", "reason"])
    return [*seen, alarms.to_pylist()]


@functools.cache
def uninterrupted(engine: str, calibrations: int) -> list[Any]:
    whole = made(engines.session(engine))
    for number in range(calibrations):
        whole.calibrate(again=number > 0, limit=GROUP)
    return finished(whole)


@pytest.mark.thorough
@pytest.mark.parametrize("at", MOMENTS)
def test_versions_and_limits_come_together(
    engine: str, at: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = engines.session(engine)
    begun = made(session)
    for calibrations in (1, 2):
        before, limits = rows_of(begun), visible(begun, LIMITS)
        with monkeypatch.context() as patch:
            dying(patch, at)
            with pytest.raises(CrashError):
                begun.calibrate(again=True, limit=GROUP)
        assert rows_of(begun)["version"] == before["version"]
        assert visible(begun, LIMITS) == limits, "no limit is seen without its version"
        if session.transactions:
            assert rows_of(begun) == before, "nothing is half written"
        begun.calibrate(again=calibrations > 1, limit=GROUP)
        assert [row["limit_no"] for row in visible(begun, LIMITS)] == [1] * 4 * calibrations
    ended = finished(begun)
    assert ended[0]
    assert ended == uninterrupted(engine, 2)
    assert begun.check_state().num_rows == 0


def test_a_run_after_a_calibration_that_died_goes_by_what_was_before(
    engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun = made(engines.session(engine))
    begun.calibrate(limit=GROUP)
    with monkeypatch.context() as patch:
        dying(patch, "limit")
        with pytest.raises(CrashError):
            begun.calibrate(again=True)
    assert finished(begun) == uninterrupted(engine, 1)
