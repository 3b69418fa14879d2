"""Alarms in the stored form: judgements and episodes that grow run by run are those of all at once.

The reference is that of the stateless form, in plain loops (tests/reference/alarms_reference.py).
"""

import contextlib
import itertools
import random
from typing import Any

import alarms_reference as plain
import engines
import gam_db
import harness
import scripts
from gam_db.errors import ConflictError
from gam_db.stored.monitor import Monitor
from sets import amounts
from strategies import Row
from visible import CrashError, crashing, visible

#: Histories of an engine in the first set and in the full one; each is one of 3 to 9 channels.
HISTORIES = {
    "duckdb": (2, 300),
    "sqlite": (1, 100),
    "postgres": (1, 40),
    "mariadb": (1, 20),
    "clickhouse": (1, 6),
    "spark": (1, 2),
}

ACTIVE = "version_id IN (SELECT MAX(version_id) FROM gam_version GROUP BY channel_id)"
LIMITS = f"SELECT * FROM gam_limit WHERE {ACTIVE}"
JUDGEMENTS = f"""
    SELECT asset, channel, judgement_no AS judgement, novel, root, evidence, is_open, last_zero,
        reference, height
    FROM gam_visible_judgement JOIN gam_version USING (version_id) JOIN gam_channel USING (channel_id)
    WHERE {ACTIVE} ORDER BY asset, channel, judgement_no
"""
EPISODES = f"""
    SELECT asset, channel, onset, first_judgement, last_judgement, is_proving, status, episode_id
    FROM gam_alarm WHERE {ACTIVE} AND status IN ('open', 'ended')
    ORDER BY asset, channel, first_judgement
"""
RECORDS = "SELECT * FROM gam_episode ORDER BY seq"
EVENTS = "SELECT * FROM gam_alarm_event ORDER BY seq"


class Course:
    """A fleet whose rows arrive bit by bit, some late, some again; with runs of each kind between."""

    LENGTH, CALIBRATED, LATE = 320, 159, 12

    def __init__(self, engine: str, seed: int) -> None:
        self.chance = random.Random(seed)
        self.session = engines.session(engine)
        self.rows = self.fleet()
        window = self.chance.choice([2, 4])
        self.method = harness.made(
            {
                **{"m": self.chance.choice([1, 2]), "tau": 1, "bins": 40, "window": window},
                **{"stride": self.chance.choice([1, window]), "max_gap": None, "target_floor": 0.9},
                "overrides": [],
            },
            {
                "intervals": [(0, self.CALIBRATED)],
                "pool": self.chance.choice([None, None, "channel", [["a1", "a2"]]]),
            },
        )
        self.per_thousand = self.chance.choice([1.0, 5.0, 30.0])
        self.family = self.chance.choice([[], ["y"], ["x", "*"]])
        self.prefix = engines.fresh_name("raised")
        self.is_pruned = False
        first = [row for row in self.rows if row[2] <= self.CALIBRATED]
        self.rest = [row for row in self.rows if row[2] > self.CALIBRATED]
        self.table = scripts.telemetry(self.session, first)

    def fleet(self) -> list[Row]:
        """Channels of few levels that now and then visit a rare one; some fail, and are mended."""
        rows: list[Row] = []
        chance = self.chance
        usual = chance.choice([0.02, 0.1, 0.3])
        for number in range(chance.choice([3, 6, 9])):
            faults = [chance.randint(self.CALIBRATED, self.LENGTH) for _ in range(2)]
            for time in range(self.LENGTH - chance.choice([0, 0, 3, 60])):
                value = chance.choice([0.0, 1.0, 2.0])
                failed = any(start <= time < start + 40 for start in faults)
                if chance.random() < (0.7 if failed else usual):
                    value = float(chance.randint(3, 40))
                rows.append((f"a{number}", "x" if number % 3 else "y", time, value))
        return rows

    def monitor(self) -> Monitor:
        source = gam_db.Source(self.table.name)
        alarms = gam_db.Alarms(f"{self.per_thousand} per 1000 judgements", self.family)
        return Monitor(
            self.session, source, *self.method, alarms, prefix=self.prefix, lookback=self.LATE
        )

    def play(self) -> None:
        """Let it happen."""
        self.monitor().migrate()
        self.monitor().calibrate()
        waiting = sorted(self.rest, key=lambda row: row[2] + self.chance.randint(0, self.LATE))
        while waiting:
            size = self.chance.randint(1, len(self.rest) // 3)
            batch, waiting = waiting[:size], waiting[size:]
            again = self.chance.sample(batch, len(batch) // 8)
            scripts.arrive(self.session, self.table, batch + again)
            self.do(self.chance.choice(["score"] * 5 + ["full", "crash", "prune", "again", "beside"]))
        self.monitor().score()

    def do(self, what: str) -> None:
        mine = self.monitor()
        if what == "crash":
            with contextlib.suppress(CrashError):
                mine.score(on_step=crashing(self.chance.randint(1, 30)))
        elif what == "prune":
            mine.prune(keep=self.chance.choice([1, 60]))
            self.is_pruned = True
        elif what == "again" and not self.is_pruned:
            mine.calibrate(again=True)
        elif what == "beside":
            with contextlib.suppress(ConflictError):
                at = iter(range(self.chance.randint(1, 30)))
                mine.score(on_step=lambda _: next(at, None) == 0 and self.monitor().score())
        else:
            mine.score(full=what == "full" and not self.is_pruned)

    def assert_as_at_once(self) -> None:
        """Compare with the reference over all rows, and the history of episodes with itself."""
        limits = plain.limits(self.rows, *self.method, self.per_thousand, self.family)
        judgements, episodes = plain.judgements(self.rows, *self.method, limits)
        mine = self.monitor()
        found = visible(mine, JUDGEMENTS)
        limit_of = {(row["asset"], row["channel"]): row for row in limits}
        for row in judgements:
            limit = limit_of[row["asset"], row["channel"]]
            row |= {name: limit[name] for name in ("reference", "height")}
        left = {key(row) for row in found}
        if self.is_pruned:
            judgements = [row for row in judgements if key(row) in left]
        harness.assert_same(judgements, found, "judgements")
        shown = visible(mine, EPISODES)
        for row in episodes:
            del row["episode"]
            row["status"] = "open" if row.pop("is_open") else "ended"
        kept = [{name: row[name] for name in row if name != "episode_id"} for row in shown]
        harness.assert_same(episodes, kept, "episodes")
        records = visible(mine, RECORDS)
        assert [row["seq"] for row in records] == list(range(1, len(records) + 1))
        opened = [row["episode_id"] for row in records if row["what"] == "opened"]
        assert opened == list(range(1, len(opened) + 1)), "each number is given once, in order"
        for _, changes in itertools.groupby(
            sorted(records, key=lambda row: (row["episode_id"], row["seq"])),
            lambda row: row["episode_id"],
        ):
            told = [row["status"] for row in changes if row["what"] != "changed"]
            assert told[0] == "open"
            assert all(one != other for one, other in itertools.pairwise(told)), told
            assert not {"merged", "withdrawn", "recalibrated"}.intersection(told[:-1])
        mine.score()
        assert visible(mine, RECORDS) == records, "a run without a change writes none"


def key(row: dict[str, Any]) -> tuple[Any, ...]:
    return row["asset"], row["channel"], row["judgement"]


@amounts("is_full", False, True)
def test_alarms_that_grow_are_those_of_all_at_once(engine: str, is_full: bool) -> None:
    for seed in range(HISTORIES[engine][is_full]):
        course = Course(engine, seed)
        course.play()
        try:
            course.assert_as_at_once()
        except AssertionError as error:
            raise AssertionError(f"history {seed}: {error}") from error
