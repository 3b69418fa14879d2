"""A run in which nothing came records nothing, channel by channel, but what the next one must know."""

import time

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning.steps import DAY
from small_plant import FIRST, LENGTH, LOOKBACK, monitor, readings
from visible import BUCKETS, NOVEL, visible

RUNS = """
    SELECT asset, COUNT(*) AS runs FROM gam_state_run
    JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)
    GROUP BY asset ORDER BY asset
"""


def runs(begun: Monitor) -> dict[str, int]:
    """Return how many rows of runs there are of each machine."""
    return {row["asset"]: row["runs"] for row in visible(begun, RUNS)}


def test_a_run_in_which_nothing_came_writes_no_row(engine: str) -> None:
    session = engines.session(engine)
    table = scripts.telemetry(session, readings(0, FIRST))
    begun = monitor(session, table.name, engines.fresh_name("state"))
    begun.migrate()
    begun.calibrate()
    scripts.arrive(session, table, readings(FIRST, LENGTH - 20))
    begun.score()
    assert runs(begun) == dict.fromkeys("abcd", 1)
    before = [visible(begun, query) for query in (BUCKETS, NOVEL)]
    for _ in range(2):
        begun.score()
    assert runs(begun) == dict.fromkeys("abcd", 1)
    assert [visible(begun, query) for query in (BUCKETS, NOVEL)] == before
    scripts.arrive(session, table, [row for row in readings(LENGTH - 20, LENGTH) if row[0] == "b"])
    begun.score()
    assert runs(begun) == {**dict.fromkeys("acd", 1), "b": 2}, "only that of the channel that goes on"
    begun.score(everything=True)
    assert runs(begun) == {**dict.fromkeys("acd", 2), "b": 3}, "calibration was counted anew"
    scripts.arrive(session, table, [row for row in readings(LENGTH - 20, LENGTH) if row[0] != "b"])
    begun.score()
    assert begun.check_state().num_rows == 0


def test_a_parked_channel_is_looked_at_once_a_day(monkeypatch: pytest.MonkeyPatch) -> None:
    """That it was looked at is recorded, though nothing was found: else each run would read it again."""
    true, later = time.time_ns, 0
    monkeypatch.setattr(time, "time_ns", lambda: true() + later * 1000)
    session = engines.session("duckdb")
    table = scripts.telemetry(session, readings(0, FIRST))
    usual = monitor(session, table.name, engines.fresh_name("state"))
    begun = gam_db.Monitor(
        session,
        usual.source,
        usual.parameters,
        usual.calibration,
        lookback=LOOKBACK,
        park_after=10,
        prefix=usual.prefix,
    )
    begun.migrate()
    begun.calibrate()
    scripts.arrive(session, table, readings(FIRST, FIRST + 60))
    begun.score()
    going_on = [row for row in readings(FIRST + 60, LENGTH) if row[0] != "d"]
    scripts.arrive(session, table, going_on)
    begun.score()
    assert begun.score().parked == 1
    before = runs(begun)
    later = DAY + 1
    assert begun.score().parked == 0, "the look of the day"
    assert runs(begun)["d"] == before["d"] + 1
    assert begun.score().parked == 1
    assert runs(begun)["d"] == before["d"] + 1
    later += DAY // 24  # the clock stands an hour ahead
    assert begun.score(everything=True).parked == 0
    later -= DAY // 24
    assert [begun.score().parked, begun.score().parked] == [0, 1], (
        "once, and not until that hour is over"
    )


def test_a_channel_without_a_row_is_recorded_once() -> None:
    """Else each run would look for it in all of the source, as for one that is new."""
    session = engines.session("duckdb")
    table = scripts.telemetry(session, readings(0, FIRST))
    begun = monitor(session, table.name, engines.fresh_name("state"))
    begun.migrate()
    begun.calibrate()
    session.execute(exp.delete(table.copy(), where=exp.column("asset").eq(exp.Literal.string("a"))))
    for _ in range(2):
        begun.score()
    assert runs(begun) == dict.fromkeys("abcd", 1)
