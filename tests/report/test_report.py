"""What is in the file: the views' figures, readings as far as they may be, the same bytes."""

import base64
import datetime as dt
import functools
import json
import random
import zlib
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from sqlglot import exp
from typer.testing import CliRunner

import engines
import gam_db
import scripts
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError
from gam_db.report import Wishes
from gam_db.report.packing import are_new, strip

PARAMETERS = gam_db.Parameters(m=3, tau=2, bins=6, window=20, stride=5, max_gap=5)
CALIBRATION = gam_db.Calibration(intervals=[(0, 199)])
MADE = dt.datetime(2026, 3, 30, tzinfo=dt.UTC)


def telemetry() -> list[Any]:
    """Signals that leave together, alone, or never, with a pause and with missing readings."""
    rows: list[Any] = []
    for asset, channel, leaves in (("A", "x", 330), ("A", "y", 332), ("A", "z", 999), ("B", "x", 250)):
        chance = random.Random(f"{asset}{channel}")
        for time in range(400):
            if asset == "B" and 210 < time < 240:
                continue
            value = time % 5 + 0.001 * chance.randrange(9) + (7 + chance.randrange(4)) * (time >= leaves)
            rows.append((asset, channel, time, None if time == 377 else value))
    return rows


def made(session: Session, name: str = "default", prefix: str = "") -> gam_db.Monitor:
    """A monitor of it, scored."""
    table = scripts.telemetry(session, telemetry())
    prefix = prefix or engines.fresh_name("report") + "_"
    source = gam_db.Source(table.name)
    monitor = gam_db.Monitor(session, source, PARAMETERS, CALIBRATION, prefix=prefix, name=name)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    return monitor


@functools.cache
def shared(engine: str) -> gam_db.Monitor:
    """One monitor of it on an engine, which no test writes to."""
    stays = engine not in engines.IN_MEMORY
    return made(engines.session(engine) if stays else engines.OPENERS[engine]())


def data_of(path: Path) -> dict[str, Any]:
    """What the page's script reads."""
    text = path.read_text(encoding="utf-8")
    found: dict[str, Any] = json.loads(
        text.partition('type="application/json">')[2].partition("</script>")[0]
    )
    return found


def unpacked(text: str, kind: str) -> Any:
    """A packed column, by its form alone."""
    return np.frombuffer(zlib.decompress(base64.b64decode(text)), "<" + kind)


def times(text: str) -> list[int]:
    return [int(one) for one in np.cumsum(unpacked(text, "f8"))]


def axes_of(key: int, bins: int = PARAMETERS.grid, m: int = PARAMETERS.m) -> tuple[int, ...]:
    """The codes of a key, the newest first."""
    return tuple(key // (bins + 3) ** axis % (bins + 3) for axis in range(m))


def rows_of(monitor: gam_db.Monitor, table: str, name: tuple[str, str]) -> list[dict[str, Any]]:
    """The rows of a signal in a view, or of its support in a table."""
    node = monitor.state.tables.table(table)
    rows = monitor.session.fetch(exp.select("*").from_(node)).to_pylist()
    if rows and "asset" in rows[0]:
        return [
            row
            for row in rows
            if (row["monitor"], row["asset"], row["channel"]) == (monitor.name, *name)
        ]
    known = rows_of(monitor, "fleet", name)[0]["version_id"]
    versions = monitor.session.fetch(exp.select("*").from_(monitor.state.tables.table("version")))
    learnt = {row["version_id"]: row["support_id"] for row in versions.to_pylist()}[known]
    return [row for row in rows if row["support_id"] == learnt]


def assert_cells(monitor: gam_db.Monitor, name: tuple[str, str], detail: dict[str, Any]) -> None:
    """The states of the page are those of the tables, in order, with the nearest healthy one of each."""
    healthy, fresh = (
        sorted(
            ((row["visits"], -row["cell_key"]) for row in rows_of(monitor, table, name)), reverse=True
        )
        for table in ("support", "quarantine")
    )
    for rows, part in ((healthy, detail["healthy"]), (fresh, detail["new"])):
        drawn = zip(*(unpacked(axis, "u4").tolist() for axis in part["axes"]), strict=True)
        assert list(drawn) == [axes_of(-key) for _, key in rows]
        assert unpacked(part["visits"], "u4").tolist() == [visits for visits, _ in rows]
    row = rows_of(monitor, "fleet", name)[0]
    low, wide = row["calibrated_lo"], (row["calibrated_hi"] - row["calibrated_lo"]) / PARAMETERS.bins
    assert len(detail["new"]["top"]) == min(8, len(fresh))
    for (axes, visits, away, _), (expected, key) in zip(detail["new"]["top"], fresh, strict=False):
        codes = axes_of(-key)
        steps = [
            max(abs(a - b) for a, b in zip(codes, axes_of(-other), strict=True)) for _, other in healthy
        ]
        assert (visits, away) == (expected, min(steps))
        for (place, code, start, end), wanted in zip(axes, codes, strict=True):
            assert code == wanted
            if 1 < code < PARAMETERS.grid + 2:
                assert place == "within"
                assert (start, end) == pytest.approx((low + (code - 2) * wide, low + (code - 1) * wide))
            else:
                assert (place, start, end) == (
                    ("below", None, pytest.approx(low, rel=1e-5))
                    if code == 1
                    else ("above", pytest.approx(row["calibrated_hi"], rel=1e-5), None)
                )
    ladder = {row["bins"]: row["floor"] for row in rows_of(monitor, "ladder", name)}
    assert dict(map(tuple, detail["ladder"])) == ladder
    assert ladder
    assert [bins for bins, _ in detail["ladder"]] == sorted(ladder, reverse=True)


def test_what_is_in_the_file_is_what_the_tables_say(engine: str, tmp_path: Path) -> None:
    monitor = shared(engine)
    other = made(monitor.session, "other", monitor.prefix)
    path = tmp_path / "page.html"
    figures = monitor.report(path, Wishes(details=4, made=MADE))
    assert figures["bytes"] == len(path.read_bytes())
    assert (figures["signals"], figures["machines"], figures["above"], figures["raw"]) == (4, 2, 3, None)
    data = data_of(path)
    health: dict[Any, list[dict[str, Any]]] = {
        (row["asset"], row["channel"]): []
        for row in monitor.health().select(["asset", "channel"]).to_pylist()
    }
    for row in monitor.health().to_pylist():
        health[row["asset"], row["channel"]].append(row)
    assert data["machines"]["together"][data["machines"]["asset"].index("A")] == 2
    readings: dict[Any, dict[int, Any]] = {}
    for asset, channel, time, value in telemetry():
        readings.setdefault((asset, channel), {})[time] = value
    for place, machine in enumerate(data["machine"]):
        name = (data["machines"]["asset"][machine], data["signals"]["name"][place])
        detail, rows, its = data["details"][str(place)], health[name], readings[name]
        assert times(detail["time"]) == [row["last_tick"] for row in rows]
        hi = unpacked(detail["hi"], "f8")
        assert [None if np.isnan(one) else one for one in hi] == [row["hi"] for row in rows]
        assert unpacked(detail["novel"], "u4").tolist() == [row["novel"] for row in rows]
        assert detail["learntFrom"] == 4
        assert sum(vectors for _, vectors, _ in detail["blocks"]) == data["signals"]["vectors"][place]
        grown = [unpacked(detail["growth"][of], "u4").tolist() for of in ("healthy", "new")]
        assert all(one == sorted(one) for one in grown)
        assert grown[0][-1] == data["signals"]["cells"][place] == detail["healthy"]["all"]
        assert grown[1][-1] == detail["new"]["all"]
        assert_cells(monitor, name, detail)
        visits = unpacked(detail["new"]["visits"], "u4").tolist()
        assert visits == sorted(visits, reverse=True)
        assert sum(visits) == sum(row["novel"] for row in rows) == detail["new"]["total"]
        for piece, expected in (("calm", [t for t in its if t <= 199]), ("onset", list(its))):
            shown = times(detail[piece]["time"])
            value = unpacked(detail[piece]["value"], "f8")
            assert shown == expected, piece
            assert [None if np.isnan(one) else one for one in value] == [its[t] for t in shown]
            if piece == "calm":
                assert unpacked(detail[piece]["new"], "u1").sum() == 0
        low, high = (unpacked(detail["envelope"][of], "f4") for of in ("low", "high"))
        known = [value for time, value in its.items() if value is not None and time >= 4]
        assert np.nanmin(low) == np.float32(min(known))
        assert np.nanmax(high) == np.float32(max(known))
        width = detail["envelope"]["length"]
        for time, value in its.items():
            if value is not None and time >= 4:
                stretch = int((time - 4) / width)
                assert low[stretch] <= np.float32(value) <= high[stretch]
    assert other.report(tmp_path / "other.html")["signals"] == 4


def test_readings_are_new_where_the_score_says(tmp_path: Path) -> None:
    """The marks of the last bucket's readings are as many as its novel vectors."""
    monitor = shared("duckdb")
    monitor.report(tmp_path / "page.html", Wishes(details=4, made=MADE))
    data = data_of(tmp_path / "page.html")
    for place in range(4):
        detail = data["details"][str(place)]
        shown, is_new = times(detail["onset"]["time"]), unpacked(detail["onset"]["new"], "u1")
        novel = unpacked(detail["novel"], "u4")
        for first, last, count in zip(times(detail["first"]), times(detail["time"]), novel, strict=True):
            marked = sum(flag for time, flag in zip(shown, is_new, strict=True) if first <= time <= last)
            assert marked == count


def test_a_detail_is_of_its_own_signal_and_no_other(tmp_path: Path) -> None:
    """C turns to what is healthy for D; E and F are one pool; a stretch holds several readings."""
    turns = {"C": 1500, "D": 0, "E": 3000, "F": 3000}
    rows: list[Any] = [
        (asset, "x", time, float(time % 5 if time < turn else 4 - time % 5) + (time == 2001))
        for asset, turn in turns.items()
        for time in range(3000)
    ]
    calibration = gam_db.Calibration(intervals=[(0, 999)], pool=[["E", "F"]])
    source = gam_db.Source(scripts.telemetry(session := DuckSession(), rows).name)
    monitor = gam_db.Monitor(session, source, PARAMETERS, calibration)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    monitor.report(tmp_path / "page.html", Wishes(details=4, made=MADE))
    data = data_of(tmp_path / "page.html")
    for place, machine in enumerate(data["machine"]):
        asset, detail = data["machines"]["asset"][machine], data["details"][str(place)]
        assert sum(vectors for _, vectors, _ in detail["blocks"]) == 996
        width = detail["envelope"]["length"]
        held: dict[int, list[float]] = {}
        for time, value in ((row[2], row[3]) for row in rows if row[0] == asset and row[2] >= 4):
            held.setdefault(int((time - 4) / width), []).append(value)
        for of, edge in (("low", min), ("high", max)):
            shown = unpacked(detail["envelope"][of], "f4")
            assert {at: shown[at] for at in held} == {at: edge(values) for at, values in held.items()}
        if asset == "C":
            assert unpacked(detail["onset"]["new"], "u1").sum() > 400


def test_the_same_tables_make_the_same_bytes_on_every_engine(engine: str, tmp_path: Path) -> None:
    wishes = Wishes(title="Plant", details=3, made=MADE, time_zone="Europe/Berlin")
    pages = []
    another = shared("duckdb") if engine != "duckdb" else made(engines.session("duckdb"))
    for number, monitor in enumerate((shared(engine), shared(engine), another)):
        monitor.report(tmp_path / f"{number}.html", wishes)
        pages.append((tmp_path / f"{number}.html").read_bytes())
    assert pages[0] == pages[1] == pages[2]


def test_without_raw_readings_no_value_of_the_source_is_in_the_file(tmp_path: Path) -> None:
    monitor = shared("duckdb")
    figures = monitor.report(tmp_path / "page.html", Wishes(raw=False))
    assert figures["raw"] == "left out"
    data = data_of(tmp_path / "page.html")
    values = {value for *_, value in telemetry() if value is not None and value % 1}

    def numbers(of: Any) -> Any:
        if isinstance(of, dict):
            for one in of.values():
                yield from numbers(one)
        elif isinstance(of, list):
            for one in of:
                yield from numbers(one)
        elif isinstance(of, float):
            yield of
        elif isinstance(of, str) and len(of) > 10 and of.startswith("eN"):
            raw = zlib.decompress(base64.b64decode(of))
            for kind, size in (("f8", 8), ("f4", 4)):
                if len(raw) % size == 0:
                    yield from np.frombuffer(raw, "<" + kind).tolist()

    found = set(numbers(data))
    assert not values & found
    assert not {float(np.float32(value)) for value in values} & found
    monitor.report(tmp_path / "raw.html")
    assert values & set(numbers(data_of(tmp_path / "raw.html"))), "with raw readings they are found"


def test_a_source_that_is_gone_is_said(tmp_path: Path) -> None:
    session = DuckSession()
    monitor = made(session)
    session.connection.execute(f'DROP TABLE "{monitor.source.relation}"')
    figures = monitor.report(tmp_path / "page.html")
    assert "could not be read" in figures["raw"]
    assert "envelope" not in data_of(tmp_path / "page.html")["details"]["0"]


def test_a_strip_says_above_exactly_where_a_bucket_is() -> None:
    hi = np.array([np.nan, 0.0, 0.25, np.nextafter(0.25, 1), 0.5, 1.0, 0.1])
    ends = np.array([19, 29, 39, 49, 59, 69, 499])
    begins = np.array([10, 20, 30, 40, 50, 60, 400])
    row = strip((begins, ends, hi), 0.25, (0, 9), (0, 500, 50))
    assert row[0] == 1
    assert row[1] == 0
    assert row[2] == 3
    assert row[3] == 127
    assert 128 <= row[4] < row[5] < row[6] == 255
    assert set(row[7:40]) == {2}
    assert 3 < row[40] < 127
    assert set(row[41:49]) == {2}
    assert row[49] == row[40]
    without = strip((begins, ends, hi), None, None, (0, 500, 50))
    assert without.max() == 127
    assert without[0] == 0


def test_a_reading_is_new_where_a_whole_vector_ends_in_no_healthy_cell() -> None:
    signal = {"bins": 6, "m": 2, "tau": 1, "max_gap": 1, "calibrated_lo": 0.0, "calibrated_hi": 6.0}
    known = np.array([2 + 9 * 2])
    new = are_new(np.array([0, 1, 2, 5, 6]), np.array([0.0, 0.5, 3.0, 3.0, np.nan]), signal, known)
    assert new.tolist() == [False, False, True, False, False]


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A database with a calibrated monitor."""
    path = tmp_path_factory.mktemp("calibrated") / "plant.duckdb"
    with duckdb.connect(path) as connection:
        connection.execute("CREATE TABLE t (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)")
        connection.executemany("INSERT INTO t VALUES (?, ?, ?, ?)", telemetry()[:400])
    words = ["--m", "2", "--bins", "4", "--window", "20", "--calibrate", "0/199", "-q"]
    done = CliRunner().invoke(app, ["calibrate", "t", "--database", str(path), *words])
    assert done.exit_code == 0
    return path


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--out", "page.txt"], "give a file in .html"),
        (["--out", "nowhere/page.html"], "the folder nowhere is not there"),
        (["--time-zone", "Mars/Olympus"], "There is no time zone 'Mars/Olympus'"),
        (["--signal", "A/w"], "There is no signal 'A/w'"),
        (["--asset", "C*"], "no calibrated signal of a machine that matches 'C*'"),
        (["--since", "7 d"], "counts time"),
        (["--made", "noon"], "--made is 'noon'"),
        (["--name", "nobody"], "There is no monitor 'nobody'"),
    ],
)
def test_bad_input_is_refused_and_nothing_written(
    calibrated: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(app, ["report", "--database", str(calibrated), *options])
    assert done.exit_code == 1
    assert said in " ".join(done.output.split())
    assert list(tmp_path.rglob("*.html")) == []


def test_the_commands_write_a_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute("CREATE TABLE t (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)")
        connection.executemany("INSERT INTO t VALUES (?, ?, ?, ?)", telemetry())
        connection.execute("COPY t TO 't.parquet'")
    words = ["--m", "2", "--bins", "4", "--window", "20", "--calibrate", "0/199", "-q"]
    for command in (
        ["calibrate", "t", *words],
        ["score"],
        ["report", "--signal", "A/z", "--details", "0"],
    ):
        done = CliRunner().invoke(app, [*command, "--database", "plant.duckdb"])
        assert done.exit_code in (0, 2), done.output
    assert "report.html: 2 machines, 4 signals, 1 in detail" in done.output
    done = CliRunner().invoke(app, ["run", "t.parquet", *words, "--no-out", "--report", "run.html"])
    assert done.exit_code == 2, done.output
    both = [data_of(tmp_path / name)["signals"] for name in ("report.html", "run.html")]
    assert both[0]["hi"] == both[1]["hi"]
    done = CliRunner().invoke(app, ["run", "t", "--database", "plant.duckdb", "--report", "x.html"])
    assert "--report works with files" in done.output


def test_too_many_details_are_refused() -> None:
    with pytest.raises(ConfigurationError, match="details is -1"):
        Wishes(details=-1)


def test_the_simulated_plant_has_every_kind_of_change(tmp_path: Path) -> None:
    done = CliRunner().invoke(app, ["demo", "--report", str(tmp_path / "demo.html")])
    assert done.exit_code == 0, done.output
    data = data_of(tmp_path / "demo.html")
    signals = data["signals"]
    assert {"ready", "too_fine", "constant"} <= set(signals["verdict"])
    assert {"ok", "setup", "not assessed"} <= set(signals["status"])
    assert {"proving", "open"} & set(signals["status"])
    assert sum(signals["fresh"]) == 1
    assert sum(signals["rising"]) >= 1
    assert sum(one is not None for one in signals["silent"]) == 10
    assert max(data["machines"]["together"]) == 5
    strips = unpacked(data["strips"], "u1")
    assert {0, 1, 2} <= set(strips.tolist())
    assert max(strips) > 200
    assert pa.table(signals).num_rows == 60


def test_a_notebook_shows_the_status_and_names_are_text() -> None:
    session = engines.session("duckdb")
    rows = [(asset.replace("B", "<b>&"), *rest) for asset, *rest in telemetry()]
    source = gam_db.Source(scripts.telemetry(session, rows).name)
    prefix = engines.fresh_name("html") + "_"
    monitor = gam_db.Monitor(session, source, PARAMETERS, CALIBRATION, prefix=prefix)
    assert "gam migrate" in monitor._repr_html_()
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    shown = monitor._repr_html_()
    assert shown.count("<tr>") == 5
    assert "<td>&lt;b&gt;&amp;</td>" in shown
    assert "<b>" not in shown
    assert shown.count("<td>proving</td>") + shown.count("<td>open</td>") == 3
