"""Alarms in the stored form: judgements and episodes that grow run by run are those of all at once.

The reference is that of the stateless form, in plain loops (tests/reference/alarms_reference.py).
"""

import contextlib
import datetime as dt
import itertools
import random
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import pytest
from sqlglot import exp

import alarms_reference as plain
import engines
import explained_reference
import gam_db
import harness
import scripts
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConflictError, ParameterError
from gam_db.stored.alarms import labels as alarms
from gam_db.stored.monitor import Monitor
from sets import amounts
from strategies import Row
from visible import CrashError, crashing, visible

pytestmark = pytest.mark.thorough

#: Plants of an engine in the first set, of 3 to 9 channels, and in the full one, of MANY; each channel
#: is a history.
BEGIN = 2  # of those, the first whose episodes have bands and cells, and where nothing is pruned
MANY = 25
PLANTS = {
    "duckdb": (1, 80),
    "sqlite": (1, 20),
    "postgres": (1, 10),
    "mariadb": (1, 5),
    "clickhouse": (1, 2),
    "spark": (1, 1),
}

ACTIVE = "version_id IN (SELECT MAX(version_id) FROM gam_state_version GROUP BY channel_id)"
LIMITS = f"SELECT * FROM gam_state_limit WHERE {ACTIVE}"
JUDGEMENTS = f"""
    SELECT asset, channel, judgement_no AS judgement, novel, root, evidence, is_open, last_zero,
        reference, height
    FROM gam_visible_judgement JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
    WHERE {ACTIVE} ORDER BY asset, channel, judgement_no
"""
EPISODES = f"""
    SELECT asset, channel, onset, first_judgement, last_judgement, is_proving, status, episode_id
    FROM gam_alarm WHERE {ACTIVE} AND status IN ('open', 'ended')
    ORDER BY asset, channel, first_judgement
"""
RAISED = f"""
    JOIN gam_state_visible_episode AS raised ON raised.episode_id = told.episode_id
    WHERE raised.{ACTIVE} AND raised.status IN ('open', 'ended')
    ORDER BY told.asset, told.channel, raised.first_judgement
"""
BANDS = f"""
    SELECT told.asset, told.channel, raised.first_judgement, told.band, told.place, told.value_from,
        told.value_to, told.novel, told.visits, told.calibration_novel, told.calibration_visits,
        told.excess
    FROM gam_alarm_band AS told {RAISED}, told.band
"""
CELLS = f"""
    SELECT told.asset, told.channel, raised.first_judgement, told.cell_rank, told.cell_key, told.visits,
        told.first_tick, told.last_tick, told.axis, told.nearest_key, told.steps, told.displacement
    FROM gam_alarm_cell AS told {RAISED}, told.cell_rank, told.axis
"""
RECORDS = "SELECT * FROM gam_state_episode ORDER BY seq"
EVENTS = "SELECT * FROM gam_alarm_event ORDER BY seq"


class Course:
    """A fleet whose rows arrive bit by bit, some late, some again; with runs of each kind between.

    Args:
        engine: its name.
        seed: of all that is by chance.
        channels: how many; by chance for 0.
    """

    LENGTH, CALIBRATED, LATE = 280, 159, 12

    def __init__(self, engine: str, seed: int, channels: int = 0) -> None:
        self.chance = random.Random(seed)
        self.session = engines.session(engine)
        self.rows = self.fleet(channels)
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

    def fleet(self, channels: int) -> list[Row]:
        """Channels of few levels that now and then visit a rare one; some fail, and are mended."""
        rows: list[Row] = []
        chance = self.chance
        usual = chance.choice([0.02, 0.1, 0.3])
        few = chance.choice([3, 6, 9])
        for number in range(channels or few):
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
        asked = gam_db.Alarms(f"{self.per_thousand} per 1000 judgements", self.family)
        return Monitor(self.session, source, *self.method, asked, prefix=self.prefix, lookback=self.LATE)

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
            left = self.chance.randint(1, 30)

            def listen(_: str) -> None:
                nonlocal left
                left -= 1
                if left == 0:
                    self.monitor().score()

            with contextlib.suppress(ConflictError):
                mine.score(on_step=listen)
        else:
            mine.score(full=what == "full" and not self.is_pruned)

    def assert_as_at_once(self) -> None:
        """Compare with the reference over all rows, and the history of episodes with itself."""
        limits = plain.limits(self.rows, *self.method, self.per_thousand, self.family)
        judgements, episodes = plain.judgements(self.rows, *self.method, limits)
        mine = self.monitor()
        found = visible(mine, JUDGEMENTS)
        assert found or not judgements
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
        if not self.is_pruned:  # else what is left of cells and judgements is told of
            asked = (self.rows, *self.method, limits, episodes)
            in_bands, in_cells = explained_reference.explained(*asked)
            harness.assert_same(in_bands, visible(mine, BANDS), "bands")
            harness.assert_same(in_cells, visible(mine, CELLS), "cells")
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
        assert mine.checked_state().differences.to_pylist() == []


def key(row: dict[str, Any]) -> tuple[Any, ...]:
    return row["asset"], row["channel"], row["judgement"]


@amounts("is_full", False, True)
def test_alarms_that_grow_are_those_of_all_at_once(engine: str, is_full: bool) -> None:
    for seed in range(BEGIN, BEGIN + PLANTS[engine][is_full]):
        course = Course(engine, seed, MANY * is_full)
        course.play()
        try:
            course.assert_as_at_once()
        except AssertionError as error:
            raise AssertionError(f"plant {seed}: {error}") from error


W = 4
PARAMETERS = gam_db.Parameters(m=1, bins=2, window=W, stride=2)
CALIBRATION = gam_db.Calibration(intervals=[(0, 8 * W - 1)])
ALARMS = gam_db.Alarms("1 per 1000 judgements")


@dataclass
class Plant:
    """One channel of a calm calibration and then windows of so many novel vectors, in DuckDB."""

    session: Any
    counts: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        values = [0.0, 1.0, 1.0, 0.0] * 8
        rows: list[Row] = [("a", "x", time, value) for time, value in enumerate(values)]
        self.table = scripts.telemetry(self.session, rows)
        self.monitor = Monitor(
            *(self.session, gam_db.Source(self.table.name), PARAMETERS, CALIBRATION, ALARMS)
        )
        self.monitor.migrate()
        self.monitor.calibrate()

    def score(self, *counts: int, **options: Any) -> None:
        start = (8 + len(self.counts)) * W
        self.counts += counts
        values = [9.0 if i < count else 1.0 for count in counts for i in range(W)]
        rows: list[Row] = [("a", "x", start + i, value) for i, value in enumerate(values)]
        scripts.arrive(self.session, self.table, rows)
        self.monitor.score(**options)

    def told(self) -> list[tuple[int, str]]:
        changes = alarms.events(self.monitor.state, "default").to_pylist()
        for later, row in enumerate(reversed(changes)):
            assert alarms.events(self.monitor.state, "default", row["seq"]).num_rows == later
        return [(row["episode_id"], row["what"]) for row in changes]

    def now(self) -> list[tuple[int, str, bool]]:
        rows = self.monitor.alarms().to_pylist()
        return [(row["episode"], row["status"], row["needs_attention"]) for row in rows]


@pytest.fixture
def plant() -> Iterator[Plant]:
    with DuckSession() as session:
        yield Plant(session)


def test_an_episode_opens_ends_and_opens_again_under_its_number(plant: Plant) -> None:
    plant.score(0, 4, 4)
    assert plant.told() == []
    plant.score(4)
    assert plant.told() == [(1, "opened")]
    assert plant.now() == [(1, "proving", True)]
    plant.score(4)
    assert plant.told() == [(1, "opened")], "that it goes on is no news"
    plant.score(0, 0, 0)
    plant.score(*[0] * 6, 4, 4, 4)
    assert plant.told() == [(1, "opened"), (1, "ended"), (1, "reopened")]
    plant.score(*[0] * 14)
    plant.score(4, 4, 4)
    assert plant.told()[3:] == [(1, "ended"), (2, "opened")]
    assert plant.now() == [(1, "proving", True), (2, "open", True)]


def test_what_late_rows_take_back_is_withdrawn_and_what_they_join_is_merged(plant: Plant) -> None:
    plant.score(4, 4, 4, *[0] * 16, 4, 4, 4)
    assert plant.now() == [(1, "proving", True), (2, "open", True)]
    first, windows = 8 * W + 3 * W, 13  # between them
    late: list[Row] = [("a", "x", first + i, 9.0) for i in range(windows * W)]
    plant.session.execute(delete(plant.table, first, first + windows * W - 1))
    scripts.arrive(plant.session, plant.table, late)
    plant.monitor.score(since=first)
    assert plant.told()[-2:] == [(1, "reopened"), (2, "merged")]
    plant.session.execute(delete(plant.table, 8 * W, 10**6))
    calm: list[Row] = [("a", "x", 8 * W + i, 1.0) for i in range(len(plant.counts) * W)]
    scripts.arrive(plant.session, plant.table, calm)
    plant.monitor.score(full=True)
    assert {what for _, what in plant.told()} >= {"opened", "withdrawn"}
    assert [status for _, status, _ in plant.now() if status not in ("merged", "withdrawn")] == []
    plant.score(4, 4, 4)
    assert plant.told()[-1] == (3, "opened"), "a number is not given again"


def delete(table: exp.Table, start: int, end: int) -> exp.Delete:
    inside = exp.column("time").between(exp.Literal.number(start), exp.Literal.number(end))
    return exp.Delete(this=table.copy(), where=exp.Where(this=inside))


def test_a_new_version_ends_what_it_does_not_find(plant: Plant) -> None:
    plant.score(4, 4, 4, 4)
    plant.monitor.calibration = gam_db.Calibration(intervals=[(0, 12 * W - 1)])
    plant.monitor.calibrate()
    plant.score(0)
    assert plant.told() == [(1, "opened"), (1, "recalibrated")]
    assert plant.now() == [(1, "recalibrated", False)]


def test_labels_decide_and_pause(plant: Plant) -> None:
    plant.score(*[0] * 9, 4, 4, 4)
    label = plant.monitor.label
    assert label("acknowledged", 1) == [1]
    assert plant.now() == [(1, "open", False)]
    label("snoozed", 1, until=dt.datetime(2020, 1, 1))
    assert plant.now() == [(1, "open", True)], "that snooze is over"
    assert label("true_fault", asset="a", span=(0, 10**6), note="gear") == [1]
    assert plant.now() == [(1, "open", True)]
    with pytest.raises(ParameterError, match="is already labelled true_fault, which false_alarm contra"):
        label("false_alarm", 1)
    label("false_alarm", 1, instead=True)
    assert plant.now() == [(1, "open", False)]
    assert plant.told() == [(1, "opened"), *[(1, "labelled")] * 4]
    plant.score(4)
    assert plant.monitor.limits()["reason"].to_pylist() == [None], "it opened after proving"


def test_a_false_alarm_in_proving_ends_judging_until_calibrated_again(plant: Plant) -> None:
    plant.score(4, 4, 4)
    plant.monitor.label("false_alarm", 1)
    assert plant.told() == [(1, "opened"), (1, "labelled"), (1, "ended")]
    assert plant.monitor.limits()["reason"].to_pylist() == ["unrepresentative"]
    plant.score(4, 4, 4)
    assert len(visible(plant.monitor, JUDGEMENTS)) == 3
    assert plant.told()[-1] == (1, "ended")
    again = plant.monitor.limits(again=True)
    assert again["reason"].to_pylist() == ["unrepresentative"], "limits made again are no calibration"
    assert plant.monitor.check_state().num_rows == 0
    plant.monitor.calibrate(again=True)
    plant.score(4)
    assert plant.monitor.limits()["reason"].to_pylist() == [None]
    assert plant.now() == [(1, "open", False)], "found again under its number, with its label"


def test_what_is_labelled_unhealthy_is_left_out_of_later_calibrations(plant: Plant) -> None:
    plant.monitor.calibration = gam_db.Calibration(intervals=[(0, 12 * W - 1)])
    plant.score(0, 4, 4, 4, 0, 0, 0)
    assert plant.monitor.label("true_fault", 1) == [1]
    service = 2 * W, 3 * W - 1
    assert plant.monitor.label("maintenance", asset="a", span=service) == []
    plant.monitor.label("new_program", asset="a", span=(0, W - 1))
    (version,) = plant.monitor.calibrate().to_pylist()
    assert version["left_out"] == 2
    left = """
        SELECT time_from, time_to FROM gam_state_calibration
        WHERE version_id = (SELECT MAX(version_id) FROM gam_state_version) ORDER BY time_from
    """
    assert visible(plant.monitor, left) == [
        {"time_from": 0, "time_to": 2 * W - 1},
        {"time_from": 3 * W, "time_to": 9 * W - 1},
    ], "the fault from its onset on"
    plant.score(0)
    assert plant.monitor.check_state().num_rows == 0
    assert plant.monitor.calibrate().num_rows == 0, "a label is no other setting"
    plant.monitor.label("false_alarm", asset="a", span=(0, 20 * W), instead=True)
    (version,) = plant.monitor.calibrate(again=True).to_pylist()
    assert version["left_out"] == 0, "that replaced all of it"


def test_limits_that_are_made_again_are_for_judgements_to_come(plant: Plant) -> None:
    plant.score(4, 4)
    before = visible(plant.monitor, JUDGEMENTS)
    plant.monitor.alarm_settings = gam_db.Alarms("5 per 1000 judgements")
    (limit,) = plant.monitor.limits(again=True, reason="stricter").to_pylist()
    assert (limit["limit_no"], limit["from_judgement"], limit["cause"]) == (2, 2, "stricter")
    plant.score(4, 0)
    assert visible(plant.monitor, JUDGEMENTS)[:2] == before
    found = visible(plant.monitor, JUDGEMENTS)
    # Height 1.5 x 500 now, so a window adds 375 at most; evidence begins anew.
    assert [row["evidence"] for row in found] == [979, 1958, 375, 0]
    plant.monitor.score(full=True)
    assert visible(plant.monitor, JUDGEMENTS) == found, "each judgement by its own limit"


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"kind": "broken", "episode": 1}, "A label is one of true_fault, false_alarm"),
        ({"kind": "true_fault", "episode": 7}, "There is no episode 7; the newest is 1"),
        ({"kind": "true_fault"}, "A label needs an episode, or an asset"),
        ({"kind": "true_fault", "asset": "b", "span": (0, 9)}, "There is no asset 'b' in the monitor"),
        ({"kind": "maintenance", "asset": "a", "span": (9, 0)}, "ends at 0, before it begins at 9"),
        ({"kind": "snoozed", "episode": 1}, "A snooze needs an end"),
        (
            {"kind": "true_fault", "episode": 1, "until": dt.datetime(2030, 1, 1)},
            "true_fault has no end",
        ),
    ],
)
def test_a_label_that_means_nothing_is_refused(plant: Plant, said: dict[str, Any], message: str) -> None:
    plant.score(4, 4, 4)
    with pytest.raises(ParameterError, match=message):
        plant.monitor.label(**said)
    assert plant.told() == [(1, "opened")]


def test_a_rate_in_days_is_refused_before_anything_is_written(plant: Plant) -> None:
    plant.monitor.alarm_settings = gam_db.Alarms("1 per month")
    with pytest.raises(ParameterError, match="the source counts time in integers"):
        plant.monitor.calibrate(again=True)
    assert len(visible(plant.monitor, "SELECT * FROM gam_state_version")) == 1
