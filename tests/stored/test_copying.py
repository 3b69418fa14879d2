"""Copying: a file of its own, whole or not at all, for those who read while scoring goes on."""

import subprocess
import sys
from pathlib import Path

import duckdb
import pytest

from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import EngineError, SourceError, StateError
from gam_db.stored.schema.copying import copy
from gam_db.stored.schema.tables import TABLES as ALL
from gam_db.stored.schema.tables import VIEWS, StateTables
from state_names import called
from stored_rows import Plant

pytestmark = pytest.mark.migrates

TABLES = StateTables(schema="factory")


def filled(session: DuckSession, tables: StateTables = TABLES) -> DuckSession:
    """A session on the state of a channel."""
    plant = Plant()
    learnt = plant.support(cells=[1, 2])
    monitor = plant.monitor()
    channel = plant.channel(monitor, "it's", "j1")
    version = plant.version(channel, learnt)
    plant.run(version, [{7: 1}, {8: 1}], still_since=1, settled_bucket=1)
    plant.run(version, [{8: 2}], from_bucket=1, still_since=1, settled_bucket=1)
    plant.run(version, [{9: 2}], from_bucket=1, committed=False)
    plant.add(
        "block", support_id=learnt, block=0, channel_id=1, first_time=0, last_time=0, vectors=1, novel=0
    )
    plant.add("ladder", support_id=learnt, bins=4, floor=0.5)
    plant.add("probe", support_id=learnt, change_no=1, change_name="frozen", vectors=9, novel=3)
    plant.add(
        "program", support_id=learnt, program_no=0, program="p", vectors=9, unvouched=1, verdict="ready"
    )
    plant.add("horizon", version_id=version.version_id, first_bucket=0, first_novel=1)
    sums = dict.fromkeys(("cells_sum", "intervals_sum", "figures_sum", "target_floor"), 1)
    hashes = dict.fromkeys(("settings_hash", "method_hash"), "h")
    plant.add("checksum", version_id=version.version_id, **sums, **hashes)
    counted = dict.fromkeys(("channels", "versions", "buckets", "differences"), 1)
    plant.add("proof", monitor_id=monitor, proved_at=1, extent="state", **counted)
    counts = {"nameless": 1, "undated": 0, "strangers": 2, "stranger_channels": 1}
    plant.add("unplaced", monitor_id=monitor, started=0, **counts)
    plant.add("left_out", monitor_id=monitor, started=0, kind="unknown", readings=2, latest=9)
    of = {"version_id": version.version_id}
    unknown = {"bucket_no": 0, "run_id": version.buckets[0][1], "program": "q", "readings": 3}
    plant.add("unknown_program", **of, **unknown, first_time=0, last_time=1)
    plant.add("buffered", **of, block=0, g=1, vectors=10, novel_buffered=1)
    plant.add("band", **of, g=1, band=0, visits=10, novel_buffered=1)
    seen = {"judgement_no": 0, "run_id": version.buckets[0][1]}
    plant.add("band_visit", **of, **seen, band=0, visits=10, novel=1)
    tried = {"move_no": 1, "factor": 1.0, "displacement": 2.0, "regained": 1, "lost": 0}
    plant.add("move", **of, **seen, **tried, vectors=10, novel=1)
    plant.add("extent", **of, vectors=80, calibration_length=80)
    made = {
        "asked": "1 per month",
        "cause": "calibrated",
        "created": 0,
        "family": 0,
        "blocks": 8,
        "g": 1,
    }
    plant.add("limit", **of, limit_no=1, from_judgement=0, **made)
    told = {"judgement_no": 0, "first_time": 0, "last_time": 1, "novel": 1, "root": 1, "reference": 2}
    plant.add(
        "judgement",
        **of,
        bucket_no=0,
        run_id=version.buckets[0][1],
        **told,
        height=3,
        evidence=4,
        is_open=1,
    )
    raised = dict.fromkeys(("onset", "first_judgement", "last_judgement", "is_proving", "noticed_at"), 0)
    raised |= {"onset_time": 0, "first_time": 0, "last_time": 1, "evidence": 4, "height": 3}
    mine = {"monitor_id": monitor, "episode_id": 1}
    plant.add("episode", **mine, **of, seq=1, what="opened", status="open", channel_id=channel, **raised)
    plant.add(
        "label", **mine, label_id=1, asset="it's", time_from=0, time_to=1, kind="snoozed", created=0
    )
    plant.write(session, tables)
    session.connection.execute("CREATE TABLE telemetry AS SELECT 1 AS reading")
    return session


def test_a_copy_holds_the_state_and_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "it's a copy.duckdb"
    with filled(DuckSession(tmp_path / "plant.duckdb", writable=True)) as session:
        for _ in range(2):  # the second replaces the first
            copy(session, TABLES, path)
        assert sorted(file.name for file in tmp_path.iterdir() if "copy" in file.name) == [path.name]
        with duckdb.connect(path, read_only=True) as reader:
            for name in (*ALL, *VIEWS):
                query = f"SELECT * FROM factory.{called(name)} ORDER BY ALL"
                if name != "migration":
                    expected = session.connection.execute(query).fetchall()
                    assert reader.execute(query).fetchall() == expected
                    assert expected
            made = reader.execute("SELECT table_name FROM information_schema.tables").fetchall()
            assert sorted(name for (name,) in made) == sorted(called(name) for name in (*ALL, *VIEWS))
            said = "SELECT comment FROM duckdb_views() WHERE view_name = 'gam_health'"
            assert "Health indicator" in reader.execute(said).fetchall()[0][0]


def test_a_state_in_memory_can_be_copied(tmp_path: Path) -> None:
    path = tmp_path / "copy.duckdb"
    with filled(DuckSession(), StateTables()) as session:
        copy(session, StateTables(), path)
    with duckdb.connect(path, read_only=True) as reader:
        assert reader.execute("SELECT COUNT(*) FROM gam_health").fetchall() == [(2,)]


def test_the_copy_before_stays_where_a_new_one_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "copy.duckdb"
    path.write_text("the copy before")
    with filled(DuckSession()) as session, monkeypatch.context() as patch:
        patch.setattr(DuckSession, "transaction", lambda _: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            copy(session, TABLES, path)
    assert path.read_text() == "the copy before"
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_what_a_killed_copy_left_is_removed_by_the_next_one(tmp_path: Path) -> None:
    path = tmp_path / "copy.duckdb"
    left = tmp_path / ".copy.duckdb.gam_0123abcd"
    with duckdb.connect(left) as connection:
        connection.execute("CREATE TABLE half AS SELECT 1 AS reading")
    damaged = tmp_path / ".copy.duckdb.gam_89abcdef"
    damaged.write_bytes(b"half a header")
    logs = [tmp_path / ".copy.duckdb.gam_00000000.wal", damaged.with_name(f"{damaged.name}.wal")]
    others = [tmp_path / ".other.duckdb.gam_0123abcd", tmp_path / ".copy.duckdb.gam_mine"]
    for file in (*logs, *others):
        file.write_bytes(b"")
    busy = tmp_path / ".copy.duckdb.gam_11111111"
    holding = "import duckdb, sys; held = duckdb.connect(sys.argv[1]); print(); sys.stdin.read()"
    with (
        filled(DuckSession(tmp_path / "plant.duckdb", writable=True)) as session,
        subprocess.Popen(
            [sys.executable, "-c", holding, str(busy)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
        ) as holder,
    ):
        assert holder.stdout is not None
        holder.stdout.readline()
        copy(session, TABLES, path)
        holder.communicate()
    there = {file.name for file in tmp_path.iterdir() if file.name.startswith(".")}
    assert there == {busy.name, *(file.name for file in others)}, "what another process writes stays"
    assert path.exists()


def test_a_copy_keeps_the_mode(tmp_path: Path) -> None:
    own, path = tmp_path / "plant.duckdb", tmp_path / "copy.duckdb"
    with filled(DuckSession(own, writable=True)) as session:
        own.chmod(0o600)
        copy(session, TABLES, path)
        assert path.stat().st_mode & 0o777 == 0o600, "that of the database"
        for mode in (0o640, 0o444):
            path.chmod(mode)
            copy(session, TABLES, path)
            assert path.stat().st_mode & 0o777 == mode, "that of the copy before"


def test_what_cannot_be_copied_is_refused(tmp_path: Path) -> None:
    own, open_elsewhere = tmp_path / "plant.duckdb", tmp_path / "open.duckdb"
    (tmp_path / "open.duckdb.wal").touch()
    with filled(DuckSession(own, writable=True)) as session:
        for path, message in (
            (own, "open in this session"),
            (tmp_path / "x" / ".." / "plant.duckdb", "open in this session"),
            (open_elsewhere, "open in a process that changes it"),
            (tmp_path / "Factory.duckdb", "same name as the schema"),
            (tmp_path / "nowhere" / "copy.duckdb", "nowhere does not exist"),
        ):
            with pytest.raises(SourceError, match=message):
                copy(session, TABLES, path)
        with pytest.raises(StateError, match="no state tables"):
            copy(session, StateTables(), tmp_path / "copy.duckdb")
        with session.transaction(), pytest.raises(EngineError, match="transaction open"):
            copy(session, TABLES, tmp_path / "copy.duckdb")
    assert not list(tmp_path.glob(".*"))
