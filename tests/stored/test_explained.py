"""Why an episode was raised, by hand: bands with their excess, cells beside the nearest healthy one."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import pytest

import gam_db
import scripts
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method.alarms import FAR, NEAR
from gam_db.stored.monitor import Monitor
from strategies import Row
from visible import visible

pytestmark = pytest.mark.thorough

W = 4
SETTING: dict[str, Any] = {"m": 1, "bins": 40, "window": W, "stride": 2, "target_floor": 0.9}
ALARMS = gam_db.Alarms("1 per 1000 judgements")

#: Eight windows from 0 to 40, so that a bin is 1 wide and a band 2; 11 is visited in one of them alone.
CALM = [[0.0, 40.0, 10.0, 10.0]] * 3 + [[0.0, 40.0, 10.0, 11.0]] + [[0.0, 40.0, 10.0, 10.0]] * 4
RAISED = [30.0, 30.0, 50.0, 10.0]
BAND = (
    *("band", "place", "value_from", "value_to", "novel", "visits"),
    *("calibration_novel", "calibration_visits", "excess"),
)
CELL = ("cell_rank", "visits", "first_tick", "last_tick", "axis", "value_from", "value_to", "steps")


@dataclass
class Plant:
    """Channels of one machine each, calm for eight windows; what follows comes window by window."""

    session: Any
    assets: tuple[str, ...] = ("a",)
    setting: dict[str, Any] = field(default_factory=lambda: SETTING)
    pool: Any = None
    calm: list[list[float]] = field(default_factory=lambda: CALM)

    def __post_init__(self) -> None:
        self.windows = len(self.calm)
        rows: list[Row] = []
        for asset in self.assets:
            rows += self.rows(asset, 0, self.calm)
        self.table = scripts.telemetry(self.session, rows)
        calibration = gam_db.Calibration(intervals=[(0, self.windows * W - 1)], pool=self.pool)
        parameters = gam_db.Parameters(**self.setting)
        asked = (gam_db.Source(self.table.name), parameters, calibration, ALARMS)
        self.monitor = Monitor(self.session, *asked)
        self.monitor.migrate()
        self.monitor.calibrate()

    @staticmethod
    def rows(asset: str, start: int, windows: list[list[Any]]) -> list[Row]:
        values = [value for window in windows for value in window]
        return [(asset, "x", start * W + i, value) for i, value in enumerate(values)]

    def arrive(self, *windows: list[Any]) -> None:
        for asset in self.assets:
            scripts.arrive(self.session, self.table, self.rows(asset, self.windows, list(windows)))
        self.windows += len(windows)

    def score(self, *windows: list[Any], **options: Any) -> None:
        self.arrive(*windows)
        self.monitor.score(**options)

    def bands(self, episode: int = 1) -> list[tuple[Any, ...]]:
        columns = ", ".join(BAND)
        query = f"SELECT {columns} FROM gam_alarm_band WHERE episode_id = {episode} ORDER BY band"
        return [tuple(row[name] for name in BAND) for row in visible(self.monitor, query)]

    def cells(self, *names: str) -> list[tuple[Any, ...]]:
        query = f"SELECT {', '.join(names)} FROM gam_alarm_cell ORDER BY cell_rank, axis"
        return [tuple(row[name] for name in names) for row in visible(self.monitor, query)]


@pytest.fixture
def session() -> Iterator[DuckSession]:
    with DuckSession() as made:
        yield made


def test_the_excess_of_a_band_is_what_calibration_does_not_explain(session: DuckSession) -> None:
    plant = Plant(session)
    plant.score(*[RAISED] * 4)
    # Opened by the fourth window: of that one alone it is known where the signal was.
    assert plant.bands() == [
        (5, "within", 10.0, 12.0, 0, 1, 1, 16, -1 / 16),
        (15, "within", 30.0, 32.0, 2, 2, 0, 0, 2.0),
        (20, "above", 40.0, None, 1, 1, 0, 0, 1.0),
    ]
    plant.score(*[RAISED] * 7)
    counted = [(band, novel, visits, excess) for band, *_, novel, visits, _, _, excess in plant.bands()]
    assert counted == [(5, 0, 5, -5 / 16), (15, 10, 10, 10.0), (20, 5, 5, 5.0)], "of five windows"


def test_bands_and_blocks_count_the_same_vectors(session: DuckSession) -> None:
    """Some cells are visited in one block, some in two that are neighbours, some in two far apart."""
    calm = [[0.0, 40.0, 10.0 + k, 11.0 + k] for k in range(10)] + [[0.0, 40.0, 10.0, 30.0]]
    monitor = Plant(session, calm=calm).monitor
    counted = """
        SELECT g, SUM({0}) AS vectors, SUM(novel_buffered) AS novel
        FROM gam_state_{1} GROUP BY g ORDER BY g
    """
    blocks = visible(monitor, counted.format("vectors", "buffered"))
    assert blocks[0]["novel"] < blocks[-1]["novel"]
    of_bands = [row for row in blocks if row["g"] in (NEAR, FAR)]
    assert visible(monitor, counted.format("visits", "band")) == of_bands


def test_how_far_away_a_block_may_be(session: DuckSession) -> None:
    """30 is visited in blocks 0, 8, 16; 20 in 1, 9, 18: block 8 alone has nobody farther than 8."""
    calm = [[0.0, 40.0, 10.0, 10.0] for _ in range(19)]
    for block, value in ((0, 30.0), (8, 30.0), (16, 30.0), (1, 20.0), (9, 20.0), (18, 20.0)):
        calm[block][3] = value
    monitor = Plant(session, calm=calm).monitor
    novel = "SELECT block FROM gam_state_buffered WHERE g = 8 AND novel_buffered > 0"
    assert visible(monitor, novel) == [{"block": 8}]
    (of_bands,) = visible(monitor, "SELECT SUM(novel_buffered) AS novel FROM gam_state_band WHERE g = 8")
    assert of_bands["novel"] == 1


@pytest.mark.full
def test_a_band_below_and_vectors_that_lack_a_sample(session: DuckSession) -> None:
    plant = Plant(session)
    gone: Any = None
    plant.score(*[[-9.0, gone, -9.0, 10.0, gone, -9.0]] * 6)
    assert plant.bands()[0] == (-1, "below", None, 0.0, 9, 9, 0, 0, 9.0)
    assert sum(row[5] for row in plant.bands()) == 3 * W, "windows of vectors, whatever is missing"
    assert {row[0] for row in plant.bands()} == {-1, 5}


@pytest.mark.full
def test_what_another_member_of_the_pool_visited_is_no_noise_of_calibration(
    session: DuckSession,
) -> None:
    plant = Plant(session, ("a", "b"), pool="channel")
    plant.score(*[RAISED] * 4)
    for episode in (1, 2):
        rates = {row[0]: row[6:8] for row in plant.bands(episode)}
        assert rates == {5: (0, 16), 15: (0, 0), 20: (0, 0)}, "both visited 11"


def test_cells_stand_beside_the_nearest_healthy_one(session: DuckSession) -> None:
    plant = Plant(session)
    plant.score(*[RAISED] * 5)
    # Judgements 3 and 4 are the episode; healthy bins are 0, 10, 11 and 39.
    first = (8 + 3) * W
    assert plant.cells(*CELL, "displacement", "place") == [
        (1, 4, first, first + W + 1, 0, 30.0, 31.0, 9, -9, "within"),
        (2, 2, first + 2, first + W + 2, 0, 40.0, None, 1, 1, "above"),
    ]


@pytest.mark.full
def test_a_cell_is_decoded_on_each_axis_from_the_newest_sample_back(
    session: DuckSession,
) -> None:
    setting = {**SETTING, "m": 2, "tau": 1, "bins": 4}
    square = [[0.0, 0.0, 4.0, 4.0]] * 9  # bins 0 and 3 by each other: (0, 0), (3, 0), (3, 3), (0, 3)
    plant = Plant(session, setting=setting, calm=square)
    plant.score(*[[1.5, 1.5, 1.5, 1.5]] * 8)
    rows = plant.cells("cell_key", "axis", "nearest_key", "steps", "displacement")
    # (1, 1) is 1 from (0, 0), 2 from the others: codes are two more, the radix is 7.
    assert rows == [(3 + 3 * 7, 0, 2 + 2 * 7, 1, 1), (3 + 3 * 7, 1, 2 + 2 * 7, 1, 1)]


@pytest.mark.full
def test_ten_cells_are_shown_equal_ones_by_their_keys(session: DuckSession) -> None:
    plant = Plant(session)
    plant.score(*[[float(12 + 4 * n + i) for i in range(W)] for n in range(6)])
    (row,) = visible(plant.monitor, "SELECT first_judgement FROM gam_state_visible_episode")
    begin = 12.0 + 4 * row["first_judgement"]
    shown = plant.cells("cell_rank", "visits", "value_from")
    assert shown == [(n + 1, 1, begin + n) for n in range(10)]


def test_late_rows_change_what_is_told_and_what_was_left_out_is_made_up_for(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant = Plant(session)
    with monkeypatch.context() as patch:
        patch.setattr("gam_db.stored.scoring.explain", lambda *_: None)  # as if it was cut short
        plant.score(*[RAISED] * 6)
    assert plant.bands() == []
    plant.monitor.score()
    assert [row[0] for row in plant.bands()] == [5, 15, 20]
    changed = [30.0, 30.0, -1.0, 10.0]
    connection = session.connection
    connection.execute(f"DELETE FROM {plant.table.name} WHERE time >= {11 * W} AND time < {12 * W}")
    scripts.arrive(session, plant.table, [("a", "x", 11 * W + i, v) for i, v in enumerate(changed)])
    plant.monitor.score(full=True)
    assert [(row[0], row[5]) for row in plant.bands()] == [(-1, 1), (5, 3), (15, 6), (20, 2)]


def test_pruning_takes_what_a_later_run_counted_again(session: DuckSession) -> None:
    plant = Plant(session)
    plant.score(*[RAISED] * 6)
    plant.monitor.score(full=True)
    before, said = visible(plant.monitor, "SELECT * FROM gam_state_band_visit"), plant.bands()
    plant.monitor.prune()
    after = visible(plant.monitor, "SELECT * FROM gam_state_band_visit")
    assert (len(before), len(after)) == (18, 9), "three bands of three judgements, counted twice"
    assert plant.bands() == said


@pytest.mark.full
def test_rows_that_went_from_the_source_are_asked_for_no_more(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant = Plant(session)
    with monkeypatch.context() as patch:
        patch.setattr("gam_db.stored.scoring.explain", lambda *_: None)
        plant.score(*[RAISED] * 6)
    session.connection.execute(f"DELETE FROM {plant.table.name} WHERE time < {13 * W}")
    plant.monitor.score()
    counted = visible(plant.monitor, "SELECT judgement_no, band, visits FROM gam_state_band_visit")
    assert sorted(tuple(row.values()) for row in counted) == [(3, -1, 0), (4, -1, 0), (5, -1, 0)]
    assert plant.bands() == []
    plant.monitor.score()
    counted = visible(
        plant.monitor, "SELECT judgement_no FROM gam_state_band_visit WHERE judgement_no < 5"
    )
    assert len(counted) == 2, "the fifth was written again, and its rows are there"
