"""Rows that are later than now decide nothing, in any form, and are named."""

import datetime as dt
from pathlib import Path

import duckdb
import pytest
from sqlglot import exp
from typer.testing import CliRunner

import engines
import gam_db
import harness
import scripts
from gam_db.checking import look_at, notes, propose
from gam_db.cli import app
from gam_db.clock import TimeKind
from gam_db.engines.session import Session
from gam_db.errors import SourceError
from gam_db.reading.ahead import Clock, ahead_sentences, zone_hours
from harness import Row

MINUTE, HOUR = 60_000_000, 3_600_000_000
#: 2026-01-01 and 2099-01-01, in microseconds.
BEGIN, FAR = 1_767_225_600_000_000, 4_070_908_800_000_000
NOW = BEGIN + 600 * MINUTE
PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=4, window=20, stride=5)


def rows(*ahead: Row) -> list[Row]:
    """Return two machines with a row a minute until now, and others."""
    return [
        (
            asset,
            "x",
            BEGIN + minute * MINUTE,
            float((minute + number) % 7 if minute < 500 else minute % 9),
        )
        for number, asset in enumerate("ab")
        for minute in range(601)
    ] + list(ahead)


def loaded(session: Session, held: list[Row]) -> exp.Table:
    """Return a table of rows whose times are timestamps."""
    time = session.engine.instant_of(TimeKind.TIMESTAMP, exp.column("time"))
    if session.engine.name == "mariadb":
        time = exp.Cast(this=time, to=exp.DataType.build("DATETIME(6)", udt=True))
    return scripts.telemetry(session, held, time)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Session, "now", lambda self: NOW)


@pytest.mark.usefixtures("clock")
@pytest.mark.parametrize(
    "calibration", [gam_db.Calibration(fraction=0.5), gam_db.Calibration(duration="300 min")]
)
def test_no_share_and_no_window_holds_a_row_that_is_ahead(
    engine: str, calibration: gam_db.Calibration
) -> None:
    session = engines.session(engine)
    late = [("a", "x", FAR + minute * HOUR, 3.0) for minute in range(300)]
    wrong = [*late, ("b", "x", NOW + 6 * MINUTE, 9.0), ("c", "x", FAR, 1.0)]
    plain, mixed = loaded(session, rows()), loaded(session, rows(*wrong))
    for question, (_, ask) in harness.QUESTIONS.items():
        answers = [
            ask(gam_db.Source(table.name), PARAMETERS, calibration, session).to_pylist()
            for table in (plain, mixed)
        ]
        assert answers[0], question
        harness.assert_same(answers[0], answers[1], question)


@pytest.mark.usefixtures("clock")
def test_a_row_within_the_tolerance_counts(engine: str) -> None:
    session = engines.session(engine)
    table = loaded(session, rows(("a", "x", NOW + 5 * MINUTE, 1.0), ("a", "x", NOW + 6 * MINUTE, 1.0)))
    calibration = gam_db.Calibration(duration="300 min")

    def newest(**tolerance: object) -> int:
        source = gam_db.Source(table.name, **tolerance)  # type: ignore[arg-type]
        found = gam_db.health_indicator(source, PARAMETERS, calibration, session)
        return len([one for one in found["asset"].to_pylist() if one == "a"])

    within = newest()
    assert newest(clock_tolerance="1 min") == within - 1
    assert newest(clock_tolerance="6 min") == newest(clock_tolerance=False) == within + 1


def test_a_script_leaves_out_what_is_ahead_whenever_it_runs(engine: str) -> None:
    """By the clock of the database: the rows are of 2026, and of 2099."""
    session = engines.session(engine)
    calibration = gam_db.Calibration(duration=dt.timedelta(minutes=300))
    answers = []
    for held in (rows(), rows(("a", "x", FAR, 3.0), ("c", "x", FAR, 3.0))):
        source = gam_db.Source(loaded(session, held).name, time_kind="timestamp")
        parameters = scripts.of_one_query(engine, PARAMETERS)
        script = gam_db.render("exact", engine, source, parameters, calibration)
        answers.append(scripts.fetched(session, script))
    assert answers[0]
    harness.assert_same(answers[0], answers[1], "exact script")


def test_a_counter_has_no_clock() -> None:
    source = gam_db.Source("telemetry", clock_tolerance="1 min")
    assert "NOW" not in gam_db.render("view", "duckdb", source, PARAMETERS)


@pytest.mark.usefixtures("clock")
def test_they_are_counted_by_channel(engine: str) -> None:
    session = engines.session(engine)
    table = loaded(session, rows(("b", "x", FAR, 1.0), ("b", "x", FAR - 1, 1.0), ("a", "x", NOW, 1.0)))
    source = gam_db.Source(table.name)
    look = look_at(session, source, PARAMETERS, gam_db.Calibration(fraction=0.5))
    assert list(look.ahead) == [{"asset": "b", "channel": "x", "ahead_rows": 2, "ahead_to": FAR}]
    (note,) = (one for one in notes(look, propose(look)) if one.subject == "ahead")
    assert note.channels == (("b", "x"),)
    assert note.text == (
        "2 rows are later than now and left out until then (b x: 2, the latest 2099-01-01T00:00:00 "
        "UTC). Correct the clock, or delete the rows."
    )


@pytest.mark.usefixtures("clock")
def test_a_source_of_the_future_is_refused_with_the_reason() -> None:
    with duckdb.connect() as connection, gam_db.connect(connection) as session:
        table = loaded(
            session, [("a", "x", NOW + 2 * HOUR - minute * MINUTE, 1.0) for minute in range(90)]
        )
        with pytest.raises(
            SourceError, match=r"All rows are later than now: 90 .* 2 h ahead .*source_time_zone"
        ):
            gam_db.support(gam_db.Source(table.name), engine=session)


@pytest.mark.parametrize(
    ("leads", "hours"),
    [
        ((2 * HOUR - MINUTE, 2 * HOUR, FAR), 2.0),
        ((5.5 * HOUR - 9 * MINUTE,) * 2, 5.5),
        ((2 * HOUR - MINUTE, 3 * HOUR), None),  # not alike
        ((2 * HOUR - 11 * MINUTE,) * 3, None),  # no half hour
        ((15 * HOUR,) * 3, None),  # no zone
        ((2 * HOUR,), None),  # one channel of three
    ],
)
def test_local_times_are_ahead_alike_by_half_hours(
    leads: tuple[float, ...], hours: float | None
) -> None:
    ahead = [
        {"asset": str(number), "channel": "x", "ahead_rows": 1, "ahead_to": NOW + int(lead)}
        for number, lead in enumerate(leads)
    ]
    assert zone_hours(ahead, 3, Clock(NOW, NOW + 5 * MINUTE)) == hours


def test_a_sentence_names_three_channels_and_counts_the_others() -> None:
    ahead = [
        {"asset": f"m{number}", "channel": "x", "ahead_rows": number, "ahead_to": FAR + number * HOUR}
        for number in range(1, 6)
    ]
    (sentence,) = ahead_sentences(ahead, 9, Clock(NOW, NOW))
    assert sentence.startswith(
        "15 rows are later than now and left out until then (m5 x: 5, the latest 2099"
    )
    assert "; and 2 more channels)" in sentence


def test_commands_name_them(tmp_path: Path) -> None:
    """As a user sees it, by the clock of this day."""
    path = tmp_path / "telemetry.duckdb"
    with duckdb.connect(str(path)) as connection, gam_db.connect(connection) as session:
        table = loaded(session, rows(("a", "x", FAR, 3.0)))
    options = ["--database", str(path), "--tau", "1", "--m", "2", "--bins", "4", "--window", "20"]
    for command in (["run", "--no-out"], ["check"]):
        result = CliRunner().invoke(app, [*command, table.name, *options])
        assert "1 row is later than now and left out until then (a x: 1, the latest 2099" in " ".join(
            result.output.split()
        )
