"""The server crashes while a run is at work, fsync on: what was committed is there, and a run goes on.

All of its processes are killed at once (kill -9). The system, and what it has still to write to disk,
goes on: to lose that, too, a machine would have to be cut off.
"""

import random
import threading
from typing import Any

import gam_db
import postgres_server
from gam_db.errors import EngineError
from sets import amounts
from small_plant import monitor, whole
from small_postgres import administrator, begin, database, rows_of, seen
from state_names import called

#: Steps that a run announces, and one more.
STEPS = 54

#: How often the server crashes, in the first set and in the full one.
CRASHES = 2, 120

#: Most rows that a run works on at once, so that it takes several transactions.
GROUP = 200

#: What the run that is cut short was to do; a plain one goes on.
RUNS: tuple[dict[str, Any], ...] = ({}, {}, {"full": True}, {"since": 150})


@amounts("crashes", *CRASHES)
def test_a_crash_of_the_server_loses_nothing(crashes: int) -> None:
    chance = random.Random(6)
    server = postgres_server.server(durable=True)
    expected = whole()
    after = by_asset(expected[0])
    with database(durable=True) as begun:
        with administrator(begun, durable=True) as connection:
            begin(connection)
            before = by_asset(seen(connection)[0])
        for number in range(crashes):
            # At a step, at any time after it, or when the run has just said that it is done.
            step, delay = 1 + 13 * (number + 1) % STEPS, chance.choice([0, 0, 0.05 * chance.random()])
            with database(begun, durable=True) as made:
                ended = is_cut_short(server, made, RUNS[number % len(RUNS)], step, delay)
                server.start(durable=True)
                with administrator(made, durable=True) as connection:
                    found = by_asset(seen(connection)[0])
                    if ended:
                        assert found == after, (step, delay)
                    for asset, last in found.items():
                        assert last in (before[asset], after[asset]), (asset, step, delay)
                    with gam_db.connect(server.url_of(made)) as session:
                        monitor(session).score(limit=GROUP)
                        assert monitor(session).check_state().num_rows == 0
                    assert seen(connection) == expected, (step, delay)
                    for table in ("bucket", "novel"):
                        counts = [
                            rows_of(connection, f"SELECT count(*) AS n FROM {called(shown + table)}")
                            for shown in ("", "visible_")
                        ]
                        assert counts[0] == counts[1], (step, delay)


def is_cut_short(
    server: postgres_server.Server, name: str, run: dict[str, Any], step: int, delay: float
) -> bool:
    """Let a run be at work while the server crashes; tell whether it had ended before."""
    heard = 0
    crash = threading.Timer(delay, server.crash)

    def listen(_: str) -> None:
        nonlocal heard
        heard += 1
        if heard == step:
            crash.start()
            if not delay:
                crash.join()

    ended = True
    try:
        with gam_db.connect(server.url_of(name)) as session:
            monitor(session).score(limit=GROUP, on_step=listen, **run)
    except EngineError:
        ended = False
    if crash.ident is None:
        crash.start()
    crash.join()
    return ended


def by_asset(buckets: list[dict[str, Any]]) -> dict[str, int]:
    """Return the newest bucket of each machine."""
    return {row["asset"]: row["bucket"] for row in buckets}
