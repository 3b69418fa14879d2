"""One verdict per signal: situations of signals, and all places that tell of them, which must agree."""

import json
from pathlib import Path
from typing import Any

import duckdb
import pyarrow.parquet as parquet
import pytest
from typer.testing import CliRunner

import engines
import gam_db
import harness
from gam_db.cli import app
from gam_db.composing import template
from gam_db.stored.monitor import Monitor
from visible import visible

#: Vectors of a window; the calibration of all, in samples, is ten of them.
W, CALIBRATED, END = 20, 200, 700

PARAMETERS = gam_db.Parameters(
    m=2,
    tau=1,
    bins=8,
    window=W,
    stride=5,
    overrides=[
        gam_db.Override(asset="few*", window=2 * W),  # 5 windows of calibration: no limit of judgements
        gam_db.Override(asset="blind*", target_floor=0.9),  # no shift lifts an indicator above that
        gam_db.Override(asset="still*", still_after=25),
    ],
)
CALIBRATION = gam_db.Calibration(intervals=[(0, CALIBRATED - 1)], pool=[["pooled", "mate"]])
ALARMS = gam_db.Alarms(rate="5 per 1000 judgements")

Span = tuple[int, int]

#: What a machine does: the times in which it goes elsewhere, and the time of its last reading.
DOES: dict[str, tuple[list[Span], int]] = {
    "ok": ([], END),
    "open": ([(500, END)], END),
    "proving": ([(300, END)], END),
    "proving over": ([(240, 340)], END),
    "over": ([(460, 560)], END),
    "far": ([(END - W + 2, END)], END),
    "few ok": ([], END),
    "few high": ([(500, END)], END),
    "few over": ([(440, 560)], END),
    "few new": ([(500, END)], END),
    "false alarm": ([(500, END)], END),
    "new program": ([(500, END)], END),
    "known fault": ([(500, END)], END),
    "put aside": ([(500, END)], END),
    "no sample": ([(240, END)], END),
    "blind": ([], END),
    "blind few": ([], END),
    "still": ([], END),
    "still open": ([(460, 620)], END),
    "silent": ([(420, 560)], 560),
    "waiting": ([], 212),
    "pooled": ([(500, END)], END),
    "mate": ([], END),
}

#: What each is, by what, since when (where the window of the onset begins), what is said of it.
EXPECTED: dict[str, tuple[str, str | None, int | None, str | None]] = {
    "ok": ("ok", "episode", None, None),
    "open": ("open", "episode", 500, None),
    "proving": ("proving", "episode", 300, None),
    "proving over": ("proving", "episode", 240, None),
    "over": ("ok", "episode", None, None),
    "far": ("ok", "episode", None, None),
    "few ok": ("ok", "indicator", None, None),
    "few high": ("high", "indicator", 480, None),
    "few over": ("ok", "indicator", None, None),
    "few new": ("labelled", "indicator", None, "new_program"),
    "false alarm": ("labelled", "episode", None, "false_alarm"),
    "new program": ("labelled", "episode", None, "new_program"),
    "known fault": ("open", "episode", 500, "true_fault"),
    "put aside": ("open", "episode", 500, "acknowledged"),
    "no sample": ("setup", None, None, None),
    "blind": ("blind", "episode", None, None),
    "blind few": ("blind", "episode", None, None),
    "still": ("standing", "episode", None, None),
    "still open": ("open", "episode", 460, None),
    "silent": ("open", "episode", 420, None),
    "waiting": ("waiting", "episode", None, None),
    "pooled": ("open", "episode", 500, None),
    "mate": ("ok", "episode", None, None),
    "constant": ("not assessed", None, None, None),
    "no data": ("not assessed", None, None, None),
    "short": ("setup", None, None, None),
}

#: What people said, by the machine whose episode it is of.
SAID = {
    "few new": "new_program",
    "false alarm": "false_alarm",
    "new program": "new_program",
    "known fault": "true_fault",
    "put aside": "acknowledged",
    "no sample": "false_alarm",
}

ABOVE = {"proving": 1, "open": 1, "high": 1, "ok": 0, "labelled": 0}


def rows() -> list[Any]:
    made: list[Any] = []
    for asset, (elsewhere, end) in DOES.items():
        for time in range(end):
            value = time % 5
            if any(first <= time < last for first, last in elsewhere):
                value = time % 7 * 3
            if asset.startswith("still") and time >= END - 50:
                value = 0
            made.append((asset, "x", time, float(value)))
    made += [("constant", "x", time, 0.0) for time in range(END)]
    made += [("no data", "x", time, float(time % 5)) for time in range(300, END)]
    made += [("short", "x", time, 8.0 * (time in (196, 199))) for time in range(195, 260)]
    return made


def plant(session: Any, source: Any, prefix: str = "gam_") -> Monitor:
    """The machines in a monitor, scored, with what people said of some."""
    monitor = Monitor(session, source, PARAMETERS, CALIBRATION, ALARMS, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    episodes = {row["asset"]: row["episode"] for row in monitor.alarms().to_pylist()}
    for asset, word in SAID.items():
        monitor.label(word, episodes[asset])
    return monitor


def test_the_views_on_every_engine(engine: str) -> None:
    session = engines.session(engine)
    with session.lent(harness.arrow(rows())) as lent:
        monitor = plant(session, gam_db.Source(lent.name), engines.fresh_name("state"))
        fleet = visible(monitor, "SELECT * FROM gam_fleet")
        assert told(fleet, "since_tick") == EXPECTED
        machines = visible(monitor, "SELECT * FROM gam_machine ORDER BY machine_rank")
        assert {row["asset"]: row["above"] for row in machines} == COUNTED
        assert {row["asset"]: row["since_tick"] for row in machines} == SINCE
        strengths = {
            row["asset"]: row["strength"] for row in visible(monitor, "SELECT * FROM gam_fleet")
        }
        assert {row["asset"]: row["strength"] for row in machines} == strengths


Told = dict[str, tuple[str, str | None, int | None, str | None]]


def told(found: Any, since: str) -> Told:
    """What a place says of each machine: status, judged by, since when, label."""
    return {row["asset"]: (row["status"], row["judged_by"], row[since], row["label"]) for row in found}


#: How many signals of each machine count, and since when the first of them is above.
COUNTED = {asset: int(ABOVE.get(said[0]) == 1) for asset, said in EXPECTED.items()}
SINCE = {asset: said[2] for asset, said in EXPECTED.items()}

#: What a run of the file says: it knows no label, so what was decided is as it was before.
UNLABELLED = EXPECTED | {
    "few new": ("high", "indicator", 480, None),
    "false alarm": ("open", "episode", 500, None),
    "new program": ("open", "episode", 500, None),
    "known fault": ("open", "episode", 500, None),
    "put aside": ("open", "episode", 500, None),
    "no sample": ("proving", "episode", 240, None),
}

#: Machines whose indicator is far above its limit, though no episode opened.
FAR = {"far", "still"}

#: Machines whose episodes ended.
ENDED = {"over", "few over", "proving over"}


def said(*words: str) -> tuple[int, Any]:
    result = CliRunner().invoke(app, [*words, "--json"])
    assert result.exit_code in (0, 2, 4), result.output
    return result.exit_code, json.loads(result.stdout)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the readings, gam.toml, and the monitor of them, labelled."""
    where = tmp_path_factory.mktemp("plant")
    parquet.write_table(harness.arrow(rows()), where / "plant.parquet")
    with duckdb.connect(str(where / "state.duckdb")) as connection:
        plant(connection, gam_db.Source(where / "plant.parquet"))
    (where / "gam.toml").write_text(SETTINGS)
    return where


SETTINGS = """
[parameters]
m = 2
tau = 1
bins = 8
window = 20
stride = 5

[[override]]
asset = "few*"
window = 40

[[override]]
asset = "blind*"
target_floor = 0.9

[[override]]
asset = "still*"
still_after = 25

[calibration]
intervals = [[0, 199]]
pool = [["pooled", "mate"]]

[alarms]
rate = "5 per 1000 judgements"
"""


def test_every_place_says_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    state = ("--database", "state.duckdb")
    code, status = said("status", *state)
    assert code == 2
    assert told(status["channels"], "onset") == EXPECTED
    assert {row["asset"]: row["above"] for row in status["machines"]} == COUNTED
    assert {row["asset"]: row["since"] for row in status["machines"]} == SINCE
    order = [row["asset"] for row in status["machines"]]
    assert sorted(order[:2]) == ["proving", "proving over"], "what asks for a decision comes first"

    code, run = said("run", "plant.parquet", "--no-out")
    assert code == 2
    found = [{**row, "label": None} for row in run["channels"]]
    assert told(found, "onset") == UNLABELLED
    for of in (status["channels"], found):
        assert {row["asset"] for row in of if row["is_far_above"] and row["episode"] is None} == FAR
    assert {row["asset"] for row in run["ended_episodes"]} == ENDED
    assert {row["asset"]: row["above"] for row in run["machines"]} == {
        asset: int(ABOVE.get(one[0]) == 1) for asset, one in UNLABELLED.items()
    }

    with duckdb.connect("state.duckdb") as connection:
        monitor = Monitor(connection, gam_db.Source("plant.parquet"))
        assert told(monitor.status().to_pylist(), "onset") == EXPECTED
        above = {asset: one for asset, one in EXPECTED.items() if COUNTED[asset]}
        assert (
            told(visible(monitor, "SELECT * FROM gam_fleet WHERE is_above = 1"), "since_tick") == above
        )
        everything = [template.text(asset) for asset in EXPECTED]
        slots: dict[str, template.Slot] = {"monitor": template.text("default"), "assets": everything}
        state_of = monitor.state
        signals = state_of.rows("export/grafana_signals", {**slots, "channels": [template.text("x")]})
        assert {row["asset"]: (row["status"], row["judged_by"], row["remark"]) for row in signals} == {
            asset: (one[0], one[1], "far above" if asset in FAR else one[3])
            for asset, one in EXPECTED.items()
        }
        alerts = state_of.rows("export/grafana_alert", {"monitor": slots["monitor"]})
        (counts,) = state_of.rows("export/grafana_counts", slots)
        ranked = state_of.rows("export/grafana_ranked", slots)
    asking = {row["asset"] for row in status["channels"] if row["needs_attention"] and row["onset"]}
    assert asking == above.keys() - {"put aside"}
    assert {row["asset"] for row in alerts if row["value"] == 1.0} == asking
    assert counts["signals_above"] == counts["machines_above"] == len(above)
    assert [row["asset"] for row in ranked] == order

    code, alarms = said("alarms", *state)
    assert code == 2
    raised = {
        row["asset"]: (row["status"], row["since"], row["label"])
        for row in alarms["episodes"]
        if row["status"] in ("proving", "open", "high")
    }
    labelled = {asset: raised.pop(asset)[2] for asset in SAID if asset in raised and not COUNTED[asset]}
    assert labelled == {asset: EXPECTED[asset][3] for asset in labelled}
    assert raised == {asset: (one[0], one[2], one[3]) for asset, one in above.items()}
    assert {row["asset"] for row in alarms["episodes"] if row["needs_attention"]} == asking
    bases = {row["basis"] for row in alarms["episodes"] if row["asset"].startswith("few")}
    assert bases == {"indicator"}

    code, stream = said("alarms", "--new", "--after", "0", *state)
    assert code == 0
    opened = {row["asset"] for row in stream["messages"] if row["what"] == "opened"}
    assert opened == {row["asset"] for row in alarms["episodes"]}
    newest = {row["asset"]: row["status"] for row in stream["changes"]}
    going = {row["asset"] for row in alarms["episodes"] if row["status"] in ("open", "high")}
    going |= {"proving"}
    assert {asset for asset, word in newest.items() if word == "open"} == going

    said("report", "--out", "page.html", *state)
    page = page_of(folder / "page.html")
    names = [page["machines"]["asset"][number] for number in page["machine"]]
    shown = page["signals"]
    columns = (shown[name] for name in ("status", "by", "since", "label"))
    assert dict(zip(names, zip(*columns, strict=True), strict=True)) == EXPECTED
    far = {
        name
        for name, one, of in zip(names, shown["far"], shown["episode"], strict=True)
        if one and not of
    }
    assert far == FAR
    machines = page["machines"]
    assert dict(zip(machines["asset"], machines["above"], strict=True)) == COUNTED
    assert machines["asset"] == order


def page_of(path: Path) -> Any:
    text = path.read_text(encoding="utf-8")
    return json.loads(text.partition('type="application/json">')[2].partition("</script>")[0])
