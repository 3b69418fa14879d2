"""gam_db.detection equals its definitions, and says why where there is nothing to compare."""

import datetime as dt
import json
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pyarrow import parquet
from rich.cells import cell_len
from typer.testing import CliRunner, Result

import detection_reference as reference
import gam_db
from detection_reference import Interval
from gam_db.cli import app
from gam_db.errors import ConfigurationError, UserError

LAST = 2**63 - 1

ASSETS, CHANNELS = ("a", "b"), ("x", "y")
Values = dict[tuple[str, str], dict[int, float | None]]
flags = st.dictionaries(st.integers(0, 30), st.sampled_from([0.0, 0.2, 0.3, 0.9, None]), max_size=20)


@st.composite
def intervals(draw: st.DrawFn, least: int) -> list[Interval]:
    """Labels or alarms; some of all channels, some without an end."""
    found = []
    for _ in range(draw(st.integers(least, 5))):
        start = draw(st.integers(-3, 33))
        end = draw(st.one_of(st.none(), st.integers(start, start + 12)))
        channel = draw(st.sampled_from([None, *CHANNELS]))
        found.append(Interval(draw(st.sampled_from(ASSETS)), channel, start, end))
    return found


def health_of(values: Values) -> pa.Table:
    rows = [
        {"asset": asset, "channel": channel, "time": time, "hi": hi}
        for (asset, channel), series in values.items()
        for time, hi in series.items()
    ]
    types = [
        ("asset", pa.string()),
        ("channel", pa.string()),
        ("time", pa.int64()),
        ("hi", pa.float64()),
    ]
    return pa.Table.from_pylist(rows, pa.schema(types))


def table_of(rows: list[Interval]) -> pa.Table:
    types = [(name, pa.string()) for name in ("asset", "channel")]
    schema = pa.schema([*types, ("start", pa.int64()), ("end", pa.int64())])
    return pa.Table.from_pylist([vars(row) for row in rows], schema)


def expected(
    raised: reference.Raised, labels: list[Interval], before: int, after: int
) -> tuple[list[tuple[Any, ...]], list[tuple[Any, ...]]]:
    """Return the rows of rates and of labels, by the reference."""
    rows, leads = [], []
    totals, total_leads = [0] * 5, []
    for series, values in reference.with_machines(raised).items():
        if not values:
            continue
        figures = reference.counts(values, series, labels, before, after)
        found = [
            (label, *reference.lead(values, label))
            for label in labels
            if label.asset == series[0]
            and (None in (series[1], label.channel) or label.channel == series[1])
        ]
        leads += [
            (*series, label.start, LAST if label.end is None else label.end, int(has), lead)
            for label, has, lead in found
        ]
        rows.append((*series, *figures, *reference.rates(figures), *events(found)))
        if series[1] is None:
            totals = [total + figure for total, figure in zip(totals, figures, strict=True)]
            total_leads += found
    whole = tuple(totals)
    rows.append((None, None, *whole, *reference.rates(whole), *events(total_leads)))  # type: ignore[arg-type]
    return rows, leads


def events(found: list[tuple[Interval, bool, int | None]]) -> tuple[int, int, int | None]:
    leads = [lead for _, _, lead in found]
    return (
        sum(has for _, has, _ in found),
        sum(lead is not None for lead in leads),
        reference.middle(leads),
    )


def key(row: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple((value is None, value or 0 if not isinstance(value, str) else value) for value in row)


def check(found: gam_db.Detection, rows: list[tuple[Any, ...]], leads: list[tuple[Any, ...]]) -> None:
    names = (
        *("asset", "channel", "counted", "left_out", "raised", "labelled", "hits"),
        *("f1", "f1_chance", "false_alarm_rate", "missed_alarm_rate"),
        *("labels", "labels_raised", "lead_time"),
    )
    assert tuple(found.rates.column_names) == names
    in_order = sorted(
        rows, key=lambda row: (row[0] is None, row[0] or "", row[1] is not None, row[1] or "")
    )
    for row, want in zip(found.rates.to_pylist(), in_order, strict=True):
        assert [row[name] for name in names[:7]] == list(want[:7])
        assert [row[name] for name in names[11:]] == list(want[11:])
        for name, share in zip(names[7:11], want[7:11], strict=True):
            assert row[name] == (None if share is None else pytest.approx(float(share), rel=1e-12)), name
    columns = ("asset", "channel", "starts_at", "ends_at", "has_values", "lead_time")
    listed = [tuple(row[name] for name in columns) for row in found.labels.to_pylist()]
    assert sorted(listed, key=key) == sorted(leads, key=key)


fleets = st.fixed_dictionaries({(asset, channel): flags for asset in ASSETS for channel in CHANNELS})


@pytest.mark.thorough
@settings(max_examples=max(30, settings().max_examples // 3))
@given(fleets, intervals(1), st.integers(0, 4), st.integers(0, 4))
def test_values_above_a_limit_are_compared_with_labels(
    values: Values, labels: list[Interval], before: int, after: int
) -> None:
    raised: reference.Raised = {
        series: sorted((time, hi > 0.2) for time, hi in of.items() if hi is not None)
        for series, of in values.items()
    }
    named = {series for series, of in values.items() if of}
    matching = [row for row in labels if any(row.holds(*series, row.start) for series in named)]
    if not matching or not any(raised.values()):
        return
    everything, labels = labels, matching
    found = gam_db.detection(
        health_of(values), table_of(everything), limit=0.2, before=before, after=after
    )
    check(found, *expected(raised, labels, before, after))
    assert found.unmatched == len(everything) - len(matching)
    assert found.unit == "steps"


@pytest.mark.thorough
@settings(max_examples=max(30, settings().max_examples // 3))
@given(fleets, intervals(1), intervals(0))
def test_values_in_an_alarm_are_compared_with_labels(
    values: Values, labels: list[Interval], alarms: list[Interval]
) -> None:
    raised: reference.Raised = {
        series: sorted(
            (time, any(alarm.holds(*series, time) for alarm in alarms))
            for time, hi in of.items()
            if hi is not None
        )
        for series, of in values.items()
    }
    named = {series for series, of in values.items() if of}
    matching = [row for row in labels if any(row.holds(*series, row.start) for series in named)]
    if not matching or not any(raised.values()):
        return
    found = gam_db.detection(health_of(values), table_of(labels), alarms=table_of(alarms))
    labels = matching
    check(found, *expected(raised, labels, 0, 0))


def test_chance_is_the_mean_over_all_places_in_time() -> None:
    """The raised values move round in a circle."""
    series = [0, 0, 1, 1, 0, 1, 0, 0, 0]
    labels = pa.table({"asset": ["a"], "start": [2], "end": [5]})
    scores = []
    for shift in range(9):
        moved = series[shift:] + series[:shift]
        rows = {"asset": ["a"] * 9, "channel": ["x"] * 9, "time": range(9), "hi": moved}
        row = gam_db.detection(pa.table(rows), labels, limit=0.5).rates.to_pylist()[0]
        scores.append(row["f1"])
        chance = row["f1_chance"]
    assert chance == pytest.approx(sum(scores) / 9)


HEALTH = pa.table({"asset": ["a"] * 3, "channel": ["x"] * 3, "time": [1, 2, 3], "hi": [0.1, 0.4, 0.9]})
LABELS = pa.table({"asset": ["a"], "start": [2], "end": [3], "event": ["worn"]})
TWICE = pa.concat_tables([HEALTH, HEALTH])
EMPTY = HEALTH.set_column(3, "hi", pa.nulls(3, pa.float64()))


def test_limits_of_channels() -> None:
    limits = pa.table({"asset": ["a"], "channel": ["x"], "hi_limit": [0.3]})
    own = HEALTH.append_column("hi_limit", pa.array([0.3] * 3))
    by_table = gam_db.detection(HEALTH, LABELS, limits=limits)
    assert by_table.rates.to_pylist()[0]["f1"] == 1
    assert gam_db.detection(own, LABELS).rates.equals(by_table.rates)
    assert by_table.without_limit == 0
    reason = limits.append_column("limit_reason", pa.array(["unrepresentative"]))
    for none in (reason, limits.slice(0, 0)):
        judged = gam_db.detection(HEALTH, LABELS, limits=none)
        assert (judged.without_limit, judged.rates.to_pylist()[0]["raised"]) == (1, 0)


def test_the_support_file_beside_the_indicators(tmp_path: Path) -> None:
    path = tmp_path / "plant.health.parquet"
    parquet.write_table(HEALTH, path)
    with pytest.raises(UserError, match="no column 'hi_limit'"):
        gam_db.detection(str(path), LABELS)
    limits = pa.table({"asset": ["a"], "channel": ["x"], "hi_limit": [0.3]})
    parquet.write_table(limits, tmp_path / "plant.support.parquet")
    assert gam_db.detection(str(path), LABELS).rates.to_pylist()[0]["f1"] == 1


def test_episodes_are_alarms() -> None:
    """What gam_db.episodes returns is read as it is."""
    alarms = pa.table({"asset": ["a"], "channel": ["x"], "first_time": [2], "last_time": [2]})
    (machine, *_) = gam_db.detection(HEALTH, LABELS, alarms=alarms).rates.to_pylist()
    assert (machine["raised"], machine["hits"], machine["lead_time"]) == (1, 1, 0)
    dated = alarms.append_column("last_tick", alarms["last_time"]).set_column(
        3, "last_time", pa.nulls(1, pa.timestamp("us"))
    )
    assert gam_db.detection(HEALTH, LABELS, alarms=dated).rates.to_pylist()[0]["raised"] == 1
    for more, raised in (
        ({"is_open": [0]}, 1),
        ({"is_open": [1]}, 2),
        ({"status": ["open"]}, 2),
        ({"status": ["withdrawn"]}, 0),
    ):
        ((name, values),) = more.items()
        table = alarms.append_column(name, pa.array(values))
        assert gam_db.detection(HEALTH, LABELS, alarms=table).rates.to_pylist()[0]["raised"] == raised


def test_alarms_of_other_machines_are_counted() -> None:
    alarms = pa.table({"asset": ["A"], "start": [3], "end": [3]})
    assert gam_db.detection(HEALTH, LABELS, alarms=alarms).alarms_unmatched == 1


def test_given_limits_come_before_those_of_the_table() -> None:
    own = HEALTH.append_column("hi_limit", pa.array([0.3] * 3))
    limits = pa.table({"asset": ["a"], "channel": ["x"], "hi_limit": [0.8]})
    assert gam_db.detection(own, LABELS, limits=limits).rates.to_pylist()[0]["raised"] == 1
    assert gam_db.detection(own, LABELS, limit=2).rates.to_pylist()[0]["raised"] == 0
    none = HEALTH.append_column("hi_limit", pa.nulls(3, pa.float64()))
    assert gam_db.detection(none, LABELS).without_limit == 1


def test_labels_without_any_end() -> None:
    for ends in (pa.nulls(1), pa.array([None], pa.string()), pa.array([None], pa.float64())):
        labels = LABELS.set_column(2, "end", ends)
        assert gam_db.detection(HEALTH, labels, limit=0.3).rates.to_pylist()[0]["labelled"] == 2


def test_text_files_are_read_as_they_are_written(tmp_path: Path) -> None:
    """Names are no numbers, and both ends of a label are read by all their words."""
    hours = [dt.datetime(2026, 1, 1) + dt.timedelta(hours=hour) for hour in range(24)]
    names = {"asset": ["1e3"] * 24, "channel": ["12:30"] * 24}
    health = pa.table({**names, "time": hours, "hi": [1.0] * 24})
    lines = ["1e3,12:30,2025-12-01 00:00:00,2025-12-01 06:00:00"] * 30_000
    lines.append("1e3,12:30,2026-01-01 03:00:00+01:00,2026-01-01 06:00:00+02:00")
    path = tmp_path / "labels.csv"
    path.write_text("asset,CHANNEL,Start,end\n" + "\n".join(lines) + "\n")
    found = gam_db.detection(health, str(path), limit=0.5)
    assert found.rates.to_pylist()[0]["labelled"] == 3  # from 02:00 to 04:00 UTC


def changed(column: str, values: Any) -> pa.Table:
    return LABELS.set_column(LABELS.column_names.index(column), column, pa.array(values))


@pytest.mark.parametrize(
    ("labels", "given", "words"),
    [
        (LABELS.drop_columns("asset"), {}, "no column 'asset'"),
        (LABELS.append_column("chanel", pa.array(["x"])), {}, "'channel'; did you mean 'chanel'"),
        (LABELS.drop_columns("start"), {}, r"'start' of the labels \(missing\)"),
        (changed("start", ["soon"]), {}, r"'start' of the labels \(VARCHAR\) must be an integer"),
        (changed("end", [dt.datetime(2026, 1, 1)]), {}, "'end' of the labels"),
        (changed("asset", pa.array([None], pa.string())), {}, "1 rows of the labels have no asset"),
        (changed("end", [1]), {}, "end before they start"),
        (changed("asset", ["z"]), {}, "None of the 1 labels"),
        (LABELS.slice(0, 0), {}, "has no row"),
        (LABELS, {"events": ["torn"]}, "no event 'torn'; their events are: worn"),
        (LABELS, {"limit": None}, "no support file"),
        (LABELS, {"limit": None, "limits": LABELS}, "limits has no column 'channel'"),
        (LABELS, {"before": "soon"}, "before is 'soon'"),
        (LABELS.drop_columns("end"), {}, r"'end' of the labels \(missing\)"),
        (LABELS, {"limit": float("nan")}, "limit is nan"),
        (LABELS, {"limit": True}, "limit is True"),
        (LABELS, {"alarms": LABELS}, "exclude each other"),
        (LABELS, {"after": -1}, "after is -1"),
    ],
)
def test_what_cannot_be_compared_is_refused(labels: pa.Table, given: dict[str, Any], words: str) -> None:
    with pytest.raises(UserError, match=words) as caught:
        gam_db.detection(HEALTH, labels, **{"limit": 0.3, **given})
    assert len(str(caught.value)) <= 300


def test_a_single_event_may_be_a_text() -> None:
    assert gam_db.detection(HEALTH, LABELS, limit=0.3, events="worn").rates.num_rows == 3


@pytest.mark.parametrize(
    ("health", "words"),
    [(TWICE, "several values at one place"), (EMPTY, "has no value yet")],
)
def test_indicators_that_tell_nothing_are_refused(health: pa.Table, words: str) -> None:
    with pytest.raises(UserError, match=words):
        gam_db.detection(health, LABELS, limit=0.3)


def test_indicators_without_time_are_refused() -> None:
    with pytest.raises(UserError, match="no time"):
        gam_db.detection(HEALTH.rename_columns(["asset", "channel", "bucket", "hi"]), LABELS, limit=0.3)


def gam(*words: str) -> Result:
    return CliRunner().invoke(app, ["evaluate", *words])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    day = [dt.datetime(2026, 1, 1) + dt.timedelta(hours=hour) for hour in range(24)]
    rows = {
        "asset": ["pump"] * 48,
        "channel": ["flow"] * 24 + ["heat"] * 24,
        "time": day * 2,
        "hi": [0.0] * 10 + [0.5] * 14 + [0.0] * 24,
    }
    parquet.write_table(pa.table(rows), "plant.health.parquet")
    Path("labels.csv").write_text(
        "asset,channel,start,end,event\n"
        "pump,,2026-01-01 12:00,2026-01-01 23:00,worn\n"
        "pump,heat,2025-12-01 12:00,2025-12-02 00:00,worn\n"
        "robot,,2026-01-01 12:00,,worn\n"
    )
    return tmp_path


@pytest.mark.usefixtures("folder")
def test_the_page() -> None:
    result = gam("plant.health.parquet", "--labels", "labels.csv", "--limit", "0.1", "--all")
    assert result.exit_code == 0, result.output
    lines = result.stdout.splitlines()
    assert max(map(cell_len, lines)) <= 80
    rows = {line.split()[0]: line.split()[1:] for line in lines if line.startswith("  ")}
    assert rows["pump"] == ["1", "1", "2", "h", "0.923", "0.538", "0.167", "0.000"]
    assert rows["heat"][:3] == ["1", "0", "-"]
    prose = " ".join(lines)
    assert "labels without a value, which count neither way: 1 " in prose
    assert "that name no machine or signal of the indicators: 1" in prose
    assert "Lead: time from" in prose
    left_out = gam("plant.health.parquet", "--labels", "labels.csv", "--limit", "0.1", "--before", "2 h")
    assert "margin of a label, which count neither way: 2" in " ".join(left_out.stdout.split())


@pytest.mark.usefixtures("folder")
def test_json_is_what_the_call_returns() -> None:
    words = ("--labels", "labels.csv", "--limit", "0.1", "--event", "worn", "--after", "1 h")
    figures = json.loads(gam("plant.health.parquet", *words, "--json").stdout)
    found = gam_db.detection(
        "plant.health.parquet", "labels.csv", limit=0.1, events=["worn"], after="1 h"
    )
    assert figures["rates"] == found.rates.to_pylist()
    assert figures["labels"] == found.labels.to_pylist()
    assert figures["unit"] == "microseconds"


@pytest.mark.usefixtures("folder")
def test_options_that_do_not_fit_are_refused() -> None:
    for words, sentence in (
        (("--limit", "0.1"), "--limit applies only with --labels"),
        (("--labels", "labels.csv", "--outcomes", "labels.csv"), "ask for different figures"),
        (("--labels", "nothing"), "no Parquet or CSV file"),
    ):
        result = gam("plant.health.parquet", *words)
        assert isinstance(result.exception, ConfigurationError) or result.exit_code == 1
        assert sentence in (result.output + str(result.exception))
