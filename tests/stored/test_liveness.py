"""Liveness: whatever clocks do, what the source holds is scored, or a command names what is not.

Rows are three hours late, an hour ahead, or of 1970, 2038 or 2099; or a gateway sends its newest row
first and the others after it. After one plain run the buckets of a channel are those of one full run
over the rows that are not ahead, or the check of the state names the channel.
"""

import random
from collections.abc import Callable
from typing import Any

import pytest
from sqlglot import exp

import comparisons
import engines
import frozen
import gam_db
import harness
import scripts
from gam_db.clock import TimeKind
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from strategies import Row
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

MINUTE = 60_000_000
HOUR = 60 * MINUTE
#: 2026-01-01, 2038 and 2099, in microseconds.
BEGIN, WRAPPED, FAR = 1_767_225_600_000_000, 2_147_483_648_000_000, 4_070_908_800_000_000
ASSETS = ("a", "b", "c")
#: Minutes of calibration, and of all.
HEALTHY, LENGTH = 300, 700
HEALTHY_END = BEGIN + (HEALTHY - 1) * MINUTE
TOLERANCE, LOOKBACK = 5 * MINUTE, HOUR

PARAMETERS = {"m": 2, "tau": 1, "bins": 4, "window": 20, "stride": 5}
CALIBRATION = {"intervals": [("2026-01-01T00:00:00", "2026-01-01T04:59:00")]}
COUNTED = {"intervals": [(BEGIN, HEALTHY_END)]}

#: Instants, each with the rows that came since the one before.
History = list[tuple[int, list[Row]]]


def history(seed: int) -> History:
    """Return the history of a number; 1 % of its times are wrong."""
    chance, drawn = random.Random(seed), History()
    waiting: dict[str, list[Row]] = {asset: [] for asset in ASSETS}
    minute = 0
    while minute < LENGTH:
        end = min(minute + (chance.choice([7, 30, 61, 200]) if minute else HEALTHY), LENGTH)
        now, arrived = BEGIN + end * MINUTE, list[Row]()
        for asset in ASSETS:
            rows = [reading(chance, asset, time) for time in range(minute, end)]
            rows = [wrong(chance, row, now) for row in rows] if minute else rows
            if minute and not waiting[asset] and chance.random() < 0.2:
                # A gateway was away: the newest row comes at once, the others with the next batch.
                waiting[asset], rows = rows[:-1], rows[-1:]
            else:
                rows, waiting[asset] = waiting[asset] + rows, []
            arrived += rows
        drawn.append((now, arrived))
        minute = end
    drawn.append((now + MINUTE, [row for rows in waiting.values() for row in rows]))
    return drawn


def reading(chance: random.Random, asset: str, minute: int) -> Row:
    """Return a row of a machine; the first one changes in the end."""
    value = float((minute + ASSETS.index(asset)) % 7) + (3.0 if minute > 500 and asset == "a" else 0.0)
    return asset, "x", BEGIN + minute * MINUTE, None if chance.random() < 0.02 else value


def wrong(chance: random.Random, row: Row, now: int) -> Row:
    """Return a row, one of a hundred with a wrong time."""
    asset, channel, time, value = row
    within = time % HOUR
    times = (within, WRAPPED + within, FAR + within, now + HOUR, max(time - 3 * HOUR, HEALTHY_END) + 1)
    return (asset, channel, chance.choice(times), value) if chance.random() < 0.01 else row


def too_late(drawn: History) -> set[str]:
    """Return the machines of which a row came later than the lookback allows, run by run."""
    late, seen = set[str](), set[Row]()
    newest: dict[str, int] = {}
    for place, (now, _) in enumerate(drawn):
        there = {row for _, rows in drawn[: place + 1] for row in rows if row[2] <= now + TOLERANCE}
        for asset, _, time, _ in there - seen:
            if time > HEALTHY_END and time < newest.get(asset, time) - LOOKBACK:
                late.add(asset)
        for asset, _, time, _ in there:
            newest[asset] = max(newest.get(asset, time), time)
        seen = there
    return late


def play(session: Session, drawn: History, clock: Callable[[int], None]) -> Monitor:
    """Let a history happen, with a plain run after each batch; return the monitor."""
    kind = TimeKind.TIMESTAMP
    instant = session.engine.instant_of(kind, exp.column("time"))
    type_name = "DATETIME(6)" if session.engine.name == "mariadb" else None
    time = exp.Cast(this=instant, to=exp.DataType.build(type_name, udt=True)) if type_name else instant
    (now, first), *rest = drawn
    clock(now)
    table = scripts.telemetry(session, first, time)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("live")
    monitor = Monitor(session, source, *harness.made(PARAMETERS, CALIBRATION), prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    for now, rows in rest:
        if rows:
            scripts.arrive(session, table, rows, time)
        clock(now)
        monitor.score()
    return monitor


def test_whatever_clocks_do_all_is_scored_or_named(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    method: tuple[Any, Any] = harness.made(PARAMETERS, COUNTED)

    def clock(now: int) -> None:
        monkeypatch.setattr(Session, "now", lambda self: now)

    for seed in range(max(engines.examples(engine) // 2, 1)):
        drawn = history(seed)
        monitor = play(engines.session(engine), drawn, clock)
        latest, first = drawn[-1][0] + TOLERANCE, drawn[0][1]
        rows = [row for _, arrived in drawn for row in arrived]
        final = [row for row in rows if row[2] <= latest]
        expected, seen = frozen.buckets(first, final, *method), visible(monitor, BUCKETS)
        differing = {asset for asset in ASSETS if of(asset, expected) != of(asset, seen)}
        assert differing <= too_late(drawn), f"seed {seed}: within the contract"
        named = {row["asset"] for row in monitor.check_state().to_pylist()}
        assert differing <= named, f"seed {seed}: the check of the state"
        assert {row["asset"] for row in monitor.score(full=True).ahead} == {
            row[0] for row in rows if row[2] > latest
        }
        harness.assert_same(expected, visible(monitor, BUCKETS), f"buckets, seed {seed}")
        novel = frozen.novel_cells(first, final, *method)
        harness.assert_same(novel, visible(monitor, NOVEL), f"novel cells, seed {seed}")
        comparisons.compared(engine, "stored", final, *method, first)


def of(asset: str, rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [row for row in rows if row["asset"] == asset]
