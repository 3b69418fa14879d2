"""Backtests: counted from the public tables by hand, and known ends of Poisson's intervals."""

import json
import random
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from typer.testing import CliRunner

import engines
import gam_db
from gam_db.alarms.backtesting import poisson_ends
from gam_db.cli import app
from gam_db.errors import CalibrationError, ParameterError

pytestmark = pytest.mark.thorough

PARAMETERS = gam_db.Parameters(m=1, bins=400, window=8, stride=4, target_floor=0.9)
CALIBRATION = gam_db.Calibration(fraction=0.4)
ALARMS = gam_db.Alarms(rate="20 per 1000 judgements")
LENGTH = 2000


def fleet() -> pa.Table:
    """Twelve channels with rare values, more of which come in the last fifth of three."""
    chance = random.Random(4)
    rows = []
    for number in range(12):
        for time in range(LENGTH):
            is_worn = number < 3 and time > 4 * LENGTH // 5
            is_rare = chance.random() < (0.6 if is_worn else 0.03)
            value = float(chance.randint(3, 400) if is_rare else chance.randint(0, 2))
            rows.append((f"a{number}", "x", time, value))
    rows += [("still", "x", time, 1.0) for time in range(LENGTH)]
    names = ("asset", "channel", "time", "value")
    return pa.table({name: [row[i] for row in rows] for i, name in enumerate(names)})


@pytest.fixture(scope="module")
def source() -> gam_db.Source:
    return gam_db.Source(fleet())


def test_figures_are_those_of_the_tables(source: gam_db.Source, engine: str) -> None:
    """Without intervals, with two that cut judgements, and with one in which an episode just opens."""
    asked = (PARAMETERS, CALIBRATION, ALARMS)
    session = engines.session(engine)
    judged = gam_db.judgements(source, *asked, session).to_pylist()
    raised = gam_db.episodes(source, *asked, session).to_pylist()
    first = {(row["asset"], row["judgement"]): row for row in judged}
    opening = first[raised[0]["asset"], raised[0]["first_judgement"]]
    just = [(opening["first_time"], opening["last_time"])]
    for healthy in (None, [(900, 1201), (1203, 1599)], just):
        found = gam_db.backtest(source, *asked, healthy, session)

        def counts(row: dict[str, Any], healthy: Any = healthy) -> bool:
            return healthy is None or any(
                start <= row["first_time"] and row["last_time"] <= end for start, end in healthy
            )

        opened = [first[row["asset"], row["first_judgement"]] for row in raised]
        assert found["judgements"] == sum(map(counts, judged))
        assert found["episodes"] == sum(map(counts, opened))
        assert found["seen"] == found["episodes"] / found["judgements"]
        assert found["lower"] <= found["seen"] <= found["upper"]
        assert found["resampled_lower"] <= found["seen"] <= found["resampled_upper"]
        by_channel = {row["asset"]: row["judgements"] for row in found["by_channel"]}
        for asset, count in by_channel.items():
            assert count == sum(row["asset"] == asset and counts(row) for row in judged)
        assert (found["channels"], sum(found["withheld"].values())) == (13, 13 - len(by_channel))
    assert found["episodes"] > 0
    assert {row["asset"] for row in raised} >= {"a0", "a1", "a2"}


def test_wear_is_not_counted_where_nothing_was_wrong(source: gam_db.Source) -> None:
    asked = (source, PARAMETERS, CALIBRATION, ALARMS)
    everything, healthy = gam_db.backtest(*asked), gam_db.backtest(*asked, [(0, 1599)])
    assert everything["episodes"] >= healthy["episodes"] + 3
    assert everything["per_day_seen"] is None  # a counter has no days
    (why,) = everything["withheld"]
    assert "constant" in why or "move" in why


@pytest.mark.parametrize(
    ("count", "ends"),
    [(0, (0.0, 3.6889)), (1, (0.0253, 5.5716)), (10, (4.7954, 18.3904)), (100, (81.364, 121.627))],
)
def test_ends_of_poisson(count: int, ends: tuple[float, float]) -> None:
    """Garwood's exact intervals, as tables print them."""
    assert poisson_ends(count) == pytest.approx(ends, abs=5e-4)


def test_what_cannot_be_counted_is_said(source: gam_db.Source) -> None:
    asked = (source, PARAMETERS, CALIBRATION, ALARMS)
    with pytest.raises(ParameterError, match="covers no full window"):
        gam_db.backtest(*asked, [(5000, 6000)])
    with pytest.raises(CalibrationError, match="healthy 1 ends"):
        gam_db.backtest(*asked, [(7, 5)])
    short = gam_db.Calibration(fraction=0.01)
    with pytest.raises(ParameterError, match="no channel has a limit"):
        gam_db.backtest(source, PARAMETERS, short, ALARMS)


def test_the_command_says_what_the_call_does(tmp_path: Path, source: gam_db.Source) -> None:
    file = tmp_path / "fleet.parquet"
    pq.write_table(fleet(), file)
    words = f"backtest {file} --m 1 --bins 400 --window 8 --stride 4 --target-floor 0.9".split()
    words += ["--calibration-fraction", "0.4", "--rate", str(ALARMS.rate), "--healthy", "900/1599"]
    told = json.loads(CliRunner().invoke(app, [*words, "--json"]).stdout)
    found = gam_db.backtest(source, PARAMETERS, CALIBRATION, ALARMS, [(900, 1599)])
    assert {name: told[name] for name in found} == found
    page = CliRunner().invoke(app, words).stdout
    assert f"{found['judgements']:,} judgements, {found['episodes']:,} episodes" in page
    assert "20 per 1000 judgements" in page
    refused = CliRunner().invoke(app, [*words, "--rate", "often"])
    assert refused.exit_code == 1
    assert "rate is 'often'" in refused.stderr
