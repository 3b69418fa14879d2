"""Killed at any moment (kill -9), a run leaves a state that it passes through, and a plain run goes on.

What a run passes through is watched on a copy of the database file, where it is left alone. The killed
ones are real processes on a real file; some are killed again before anyone looks.
"""

import itertools
import random
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

import comparisons
import frozen
import gam_db
import harness
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import StateError
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import TABLES
from killed_plant import ALARMS, CALIBRATION, LOOKBACK, METHOD, PARAMETERS, plant
from sets import amounts
from state_names import called
from strategies import Row
from test_migrations import catalog
from victims import Moment, Victims, carry_out
from visible import BUCKETS, NOVEL, put, rows_of

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]

#: How many running processes are killed of each command, in the first set and in the full one.
KILLS = {"migrate": (6, 40), "calibrate": (8, 60), "score": (15, 200), "label": (3, 40)}

#: Most rows that a run works on at once, so that it takes several transactions.
GROUP = 1000

#: What calibration leaves, and what says of which version it is.
LEARNT = {
    "calibration": "version_id",
    "bounds": "support_id",
    "block": "support_id",
    "ladder": "support_id",
    "probe": "support_id",
    "support": "support_id",
}

SIZES = "SELECT table_name, estimated_size FROM duckdb_tables() WHERE NOT temporary ORDER BY ALL"

#: Columns that differ from run to run; what a checksum sums has the time of creation in it.
STAMPS = ("run_id", "created", "started", "committed", "applied_at", "figures_sum", "noticed_at")

#: Alarms as they are seen, names in the place of numbers.
NAMED = "JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)"
JUDGEMENTS = f"""
    SELECT asset, channel, judgement_no, known.* EXCLUDE (run_id, version_id)
    FROM gam_visible_judgement AS known {NAMED} ORDER BY ALL
"""
EPISODES = """
    SELECT asset, channel, what, known.status, merged_into, onset, first_judgement, last_judgement,
        onset_time, first_time, last_time, evidence, height, is_proving
    FROM gam_state_episode AS known
    JOIN (SELECT version_id, channel_id FROM gam_state_version) AS made USING (version_id)
    JOIN gam_state_channel AS named ON named.channel_id = made.channel_id
    ORDER BY asset, channel, seq
"""

State = dict[str, list[tuple[Any, ...]]]
Look = Callable[[DuckSession], Any]


@pytest.fixture(scope="module")
def program() -> Iterator[Victims]:
    victims = Victims()
    yield victims
    victims.close()


@pytest.fixture
def victims(program: Victims) -> Victims:
    program.killed = 0
    return program


@contextmanager
def opened(path: Path) -> Iterator[DuckSession]:
    with DuckSession(path, threads=1, writable=True) as session:
        yield session


def monitor(session: DuckSession) -> Monitor:
    parameters, calibration = harness.made(PARAMETERS, CALIBRATION)
    asked = gam_db.Alarms(ALARMS)
    return Monitor(
        session, gam_db.Source("telemetry"), parameters, calibration, asked, lookback=LOOKBACK
    )


def founded(path: Path, rows: list[Row]) -> Path:
    """Make a database file that holds rows of the source."""
    with opened(path) as session:
        session.connection.execute(
            "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
        )
        put(session.connection, rows)
    return path


def stored(session: DuckSession) -> State:
    """Return all rows of the state tables, hidden or not, but for what differs from run to run."""
    there = session.relations()
    state: State = {}
    for table in TABLES:
        columns = [column for column in there[called(table)] if column not in STAMPS]
        query = f"SELECT {', '.join(columns)} FROM {called(table)} ORDER BY ALL"
        state[table] = session.connection.execute(query).fetchall()
    return state


def results(session: DuckSession) -> list[Any]:
    """Return what is seen and what was learnt, names in the place of numbers."""
    connection = session.connection
    found: list[Any] = [rows_of(connection, BUCKETS), rows_of(connection, NOVEL)]
    for table, key in LEARNT.items():
        query = f"""
            SELECT named.asset, named.channel, frozen.version_no, learnt.*
            FROM {called(table)} AS learnt JOIN gam_state_version AS frozen USING ({key})
            JOIN gam_state_channel AS named ON named.channel_id = frozen.channel_id
        """
        rows = [
            tuple((name, value) for name, value in row.items() if not name.endswith("_id"))
            for row in rows_of(connection, query)
        ]
        found.append(sorted(rows, key=repr))
    return found


def by_channel(session: DuckSession) -> dict[tuple[str, str], list[Any]]:
    """Return what is seen of each channel; that nothing else is there is checked."""
    seen: dict[tuple[str, str], list[Any]] = {}
    for table, query in (
        *(("bucket", BUCKETS), ("novel", NOVEL)),
        *(("judgement", JUDGEMENTS), ("episode", EPISODES)),
    ):
        rows = rows_of(session.connection, query)
        kept = session.connection.execute(f"SELECT COUNT(*) FROM {called(table)}").fetchall()
        assert kept == [(len(rows),)], "rows that are hidden, or of no run, are left"
        for row in rows:
            seen.setdefault((row["asset"], row["channel"]), []).append(row)
    return seen


# Killing


@dataclass
class Course:
    """What an uninterrupted run goes through.

    Attributes:
        seconds: it takes, from when the file is open until it is closed.
        states: those before it, after each of its transactions, and in the end.
        steps: what it announces, that the file is open first of all.
    """

    seconds: float
    states: list[Any] = field(default_factory=list)
    steps: list[str] = field(default_factory=lambda: ["open"])


def course(victims: Victims, before: Path, look: Look, **order: Any) -> Course:
    """Let a command run to its end on copies of a file, and note the states on the way."""
    copy = before.with_suffix(".course")
    passed = Course(victims.lifetime(database=str(shutil.copy(before, copy)), **order, **METHOD))
    shutil.copy(before, copy)

    sizes: list[Any] = []

    def note(step: str = "") -> None:
        passed.steps += [step] * bool(step)
        # Looking takes a while; what is to be seen has changed only if some table has grown.
        now = session.connection.execute(SIZES).fetchall()
        if not sizes or sizes[-1] != now:
            sizes.append(now)
            passed.states.append(look(session))

    with opened(copy) as session:
        carry_out(monitor(session), order["command"], order["options"], note)
        note()
    copy.unlink()
    return passed


def moments(chance: random.Random, passed: Course) -> Iterator[Moment]:
    """Yield random moments: any time, on a step, and shortly after what precedes a transaction."""
    before = [n for n, step in enumerate(passed.steps, 1) if step in ("writing", "verdicts", "run_up")]
    while True:
        yield Moment(1, chance.uniform(0, passed.seconds))
        yield Moment(chance.randint(1, len(passed.steps)))
        if before:
            yield Moment(chance.choice(before))
            yield Moment(chance.choice(before), chance.uniform(0, 0.2 * passed.seconds))


def hit(
    victims: Victims,
    chosen: Iterator[Moment],
    before: Path,
    path: Path,
    again: bool = False,
    **order: Any,
) -> tuple[Moment, bool]:
    """Kill a process at work on a copy of a file; return when, and whether the next one was hit, too.

    One that was faster does not count. With ``again`` the process that goes on with the copy is killed
    as well, unless it is faster.
    """
    for moment in itertools.islice(chosen, 50):
        for left in path.parent.glob(f"{path.name}*"):
            left.unlink()
        shutil.copy(before, path)
        if victims.kill(moment, database=str(path), **order, **METHOD):
            return moment, again and victims.kill(next(chosen), database=str(path), **order, **METHOD)
    raise AssertionError("fifty processes ended before they were killed")


def test_tens_of_processes_are_killed_in_the_first_set_and_hundreds_in_the_full_one() -> None:
    first, full = (sum(numbers) for numbers in zip(*KILLS.values(), strict=True))
    assert first >= 30
    assert full >= 300


@amounts("kills", *KILLS["migrate"])
def test_killed_while_migrating(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(1)
    empty = founded(tmp_path / "empty.duckdb", plant().first[:50])
    path = tmp_path / "plant.duckdb"

    def look(session: DuckSession) -> Any:
        there = "gam_state_migration" in session.relations()
        query = "SELECT number, name, checksum FROM gam_state_migration ORDER BY number"
        return catalog(session), session.connection.execute(query).fetchall() if there else []

    order: dict[str, Any] = {"command": "migrate", "options": {}}
    passed = course(victims, empty, look, **order)
    nothing, everything = passed.states[0], passed.states[-1]  # what is between them is one transaction
    chosen = moments(chance, passed)
    while victims.killed < kills:
        moment, _ = hit(victims, chosen, empty, path, **order)
        with opened(path) as session:
            assert look(session) in (nothing, everything), moment
            if look(session) == nothing:
                with pytest.raises(StateError, match="run `gam migrate`"):
                    monitor(session).score()
            monitor(session).migrate()
            assert look(session) == everything, moment


@amounts("kills", *KILLS["calibrate"])
def test_killed_while_calibrating(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(2)
    path = tmp_path / "plant.duckdb"
    before = founded(tmp_path / "before.duckdb", plant().first)
    with opened(before) as session:
        monitor(session).migrate()
    order: dict[str, Any] = {"command": "calibrate", "options": {"limit": GROUP}}
    passed = course(victims, before, stored, **order)
    assert len(passed.states) == 3, "before, the monitor, and all versions with their limits"
    assert passed.steps.count("writing") >= 3, "at least three groups"
    chosen = moments(chance, passed)
    while victims.killed < kills:
        moment, _ = hit(victims, chosen, before, path, chance.random() < 0.3, **order)
        with opened(path) as session:
            assert stored(session) in passed.states, moment
            monitor(session).calibrate(limit=GROUP)
            assert stored(session) == passed.states[-1], moment


@amounts("kills", *KILLS["label"])
def test_killed_while_labelling(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(4)
    before, path = tmp_path / "before.duckdb", tmp_path / "plant.duckdb"
    with opened(founded(before, plant().first)) as session:
        monitor(session).migrate()
        monitor(session).calibrate()
        put(session.connection, list(itertools.chain(*plant().batches)))
        monitor(session).score()
        numbers = sorted(monitor(session).alarms()["episode"].to_pylist())
    kinds = itertools.cycle(["true_fault", "false_alarm", "maintenance", "acknowledged"])
    labels: list[dict[str, Any]] = [{"kind": next(kinds), "episode": number} for number in numbers]
    labels.append({"kind": "maintenance", "asset": "b", "span": [0, 50]})
    order: dict[str, Any] = {"command": "label", "options": {"labels": labels}}
    passed = course(victims, before, stored, **order)
    assert len(passed.states) == 1 + len(labels) >= 5
    chosen = moments(chance, passed)
    while victims.killed < kills:
        moment, _ = hit(victims, chosen, before, path, **order)
        with opened(path) as session:
            assert stored(session) in passed.states, moment
    with opened(path) as session:
        assert monitor(session).check_state().num_rows == 0


@amounts("kills", *KILLS["score"])
def test_killed_while_scoring(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(3)
    before, path = tmp_path / "before.duckdb", tmp_path / "plant.duckdb"
    with opened(founded(before, plant().first)) as session:
        monitor(session).migrate()
        monitor(session).calibrate(limit=GROUP)
    rounds = [plant().first[:0], *plant().batches, []]
    each = -(-kills // len(rounds))
    transactions = 0
    for number, rows in enumerate(rounds, start=1):
        with opened(before) as session:
            put(session.connection, rows)
        # The first run reads everything, and so does the last; between them there are few rows.
        limit = {1: GROUP, len(rounds): 2 * GROUP}.get(number, GROUP // 2)
        options: dict[str, Any] = {"limit": limit, "full": number == len(rounds)}
        order: dict[str, Any] = {"command": "score", "options": options}
        passed = course(victims, before, by_channel, **order)
        transactions += passed.steps.count("writing")
        start, end = passed.states[0], passed.states[-1]
        chosen = moments(chance, passed)
        while victims.killed < min(number * each, kills):
            moment, twice = hit(victims, chosen, before, path, chance.random() < 0.3, **order)
            with opened(path) as session:
                found = by_channel(session)
                for name in end:
                    assert found.get(name) in (start.get(name), end[name]), (name, moment)
                assert twice or found in passed.states, moment
                monitor(session).score(**options)
                assert by_channel(session) == end, moment
        shutil.copy(path, before)
    assert transactions >= 2 * len(rounds)
    with opened(before) as session:
        assert rows_of(session.connection, "SELECT 1 AS hit FROM gam_alarm WHERE status = 'open'")
        assert monitor(session).check_state().num_rows == 0
    with opened(before) as session, opened(founded(tmp_path / "fresh.duckdb", plant().first)) as fresh:
        monitor(fresh).migrate()
        monitor(fresh).calibrate()
        put(fresh.connection, list(itertools.chain(*plant().batches)))
        monitor(fresh).score()
        assert results(session) == results(fresh)
        asked = (plant().first, plant().final, *harness.made(PARAMETERS, CALIBRATION))
        harness.assert_same(frozen.buckets(*asked), rows_of(session.connection, BUCKETS), "buckets")
        harness.assert_same(frozen.novel_cells(*asked), rows_of(session.connection, NOVEL), "novel")
        comparisons.compared("duckdb", "stored", plant().final, *asked[2:], plant().first)
