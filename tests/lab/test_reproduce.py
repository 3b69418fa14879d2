"""The paper's experiments: end to end in small, resumed from files, and read honestly."""

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

from gam_db.cli import app
from gam_db.errors import ConfigurationError
from gam_db.lab.reproduce import page, sensitivity
from gam_db.lab.reproduce.methods import METHODS, chosen
from gam_db.lab.reproduce.paper import TABLE2
from gam_db.lab.reproduce.recordings import recordings
from gam_db.lab.reproduce.results import Results
from gam_db.lab.reproduce.table2 import Row, Table, agreement, table2


def invoked(*words: str) -> Any:
    return CliRunner().invoke(app, ["reproduce", *words])


def test_table2_from_the_command_line_and_again_from_its_files(tmp_path: Path) -> None:
    words = ("table2", "--quick", "--methods", "centroid,dse", "--seeds", "1", "--results")
    first = invoked(*words, str(tmp_path))
    assert first.exit_code == 0, first.stderr
    for said in ("QUICK", "DSE", "0.998", "Centroid", "chance", "no evidence"):
        assert said in first.stdout
    files = sorted(file.name for file in (tmp_path / "table2-quick").iterdir())
    assert files == ["centroid-0.json", "dse-0.json"]
    record = json.loads((tmp_path / "table2-quick" / "dse-0.json").read_text())
    assert record["settings"]["tau"] == 58
    assert record["figures"]["values"] == 40_000 * 6 // 10 - 5_000 + 1
    assert record["figures"]["mon"] > 0.9
    again = invoked(*words, str(tmp_path))
    assert again.stdout == first.stdout, "seconds included: nothing was run twice"


def test_a_result_is_used_again_only_under_the_same_settings(tmp_path: Path) -> None:
    results, runs = Results(tmp_path), []

    def compute() -> dict[str, Any]:
        runs.append(1)
        return {"number": len(runs)}

    assert results.get("a/b", {"m": 3}, compute) == {"number": 1}
    assert results.get("a/b", {"m": 3}, compute) == {"number": 1}
    assert results.get("a/b", {"m": 4}, compute) == {"number": 2}
    (tmp_path / "a" / "b.json").write_text("{")
    with pytest.raises(ConfigurationError, match=r"b\.json is no result"):
        results.get("a/b", {"m": 4}, compute)


def test_what_was_interrupted_goes_on_where_it_was(tmp_path: Path) -> None:
    seen: list[str] = []

    def show(text: str) -> None:
        seen.append(text)
        if text == "Centroid, seed 0":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        table2(["dse", "centroid"], 1, True, Results(tmp_path), show)
    assert [file.name for file in (tmp_path / "table2-quick").iterdir()] == ["dse-0.json"]


def test_the_paper_and_the_list_of_methods_agree() -> None:
    assert set(TABLE2) == set(METHODS)
    assert len(METHODS) == 11
    for row in TABLE2.values():  # the paper's Global is the mean of the other three
        assert row.global_score == pytest.approx((row.mon + row.corr + row.rob) / 3, abs=1.5e-3)


def test_rank_correlation_of_two_orders() -> None:
    assert agreement(["a", "b"], ["a", "b"]) is None
    assert agreement(["a", "b", "c"], ["a", "x", "b", "c"]) == pytest.approx(1)
    assert agreement(["a", "b", "c"], ["c", "b", "a"]) == pytest.approx(-1)
    assert agreement(["b", "a", "c", "d"], ["a", "b", "c", "d"]) == pytest.approx(0.8)


def test_the_page_says_which_methods_come_out_elsewhere() -> None:
    order = [*list(TABLE2)[1:], "forest"]  # the paper's first comes out last
    chance = dict.fromkeys(("mon", "corr", "rob"), 0.2)
    rows = []
    for name in order:
        paper = TABLE2[name]._asdict()
        numbers = paper | {"global_score": paper["global_score"] - 0.1 * (name == "mlp")}
        rows.append(Row(name, numbers, dict.fromkeys(numbers, None), 1.0))
    said = list(page.table2(Table(rows, 1, 200_000, 24, chance, agreement(order, list(TABLE2)), False)))
    places = [line for line in said if ": place " in line]
    assert len(places) == 2
    assert "MLP: place 7, Global 0.738; paper 8, 0.838: the length of training" in places[0]
    assert "Isolation Forest: place 11, Global 0.991; paper 1, 0.991" in places[1]
    assert any("0.50 over 11 methods" in line for line in said)
    assert not any("QUICK" in line for line in said)


def test_recordings_of_machines_that_failed(tmp_path: Path) -> None:
    """One channel wears in both machines that fail, one never moves, one machine did not fail."""
    samples, random = 4_000, np.random.default_rng(0)
    parts = []
    for asset in ("one", "two", "three"):
        for channel in ("worn", "still"):
            values = np.sin(np.arange(samples) / 7) + 0.01 * random.standard_normal(samples)
            values += np.linspace(0, 0.5, samples)
            if channel == "still":
                values[:] = 1.0
            names = {"asset": pa.array([asset] * samples), "channel": pa.array([channel] * samples)}
            parts.append(pa.table({**names, "t": np.arange(samples), "value": values}))
    folder = tmp_path / "production_plant"
    folder.mkdir()
    parquet.write_table(pa.concat_tables(parts), folder / "series.parquet")
    labels = {"asset": ["one", "two"], "event": ["end_of_life"] * 2, "start": [3500] * 2}
    parquet.write_table(pa.table({**labels, "end": [samples - 1] * 2}), folder / "labels.parquet")

    (row,) = recordings(tmp_path, ["plant"], ["dse"], False, Results(tmp_path / "results"), print)
    assert (row.channels, row.series) == (1, 2)
    assert row.certified.constant == {(asset, "still") for asset in ("one", "two", "three")}
    assert row.metrics["mon"] is not None
    assert row.metrics["mon"] > 0.6
    assert row.signed[1] == 1
    assert row.metrics["prog"] is not None
    assert row.chance["mon"] is not None
    assert 0 < row.chance["mon"] < 0.9
    words = ("--only", "plant", "--methods", "dse", "--results", str(tmp_path / "results"))
    shown = invoked("recordings", "--data", str(tmp_path), *words)
    assert "1 channels (2 series" in " ".join(shown.stdout.split()), shown.stderr


@pytest.mark.thorough
def test_sensitivity_in_small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, few in (("DIMENSIONS", (2, 5)), ("DELAYS", (1, 50)), ("ROBOTS", 4)):
        monkeypatch.setattr(sensitivity, name, few)
    cells = sensitivity.sensitivity("fleet", True, Results(tmp_path), lambda text: None)
    assert [(cell.m, cell.tau) for cell in cells] == [(2, 1), (5, 1), (2, 50), (5, 50)]
    floors = {(cell.m, cell.tau): cell.floor for cell in cells}
    assert floors[2, 1] < floors[5, 1] < floors[5, 50], "the support grows sparse with m and tau"
    by_floor = sorted(cells, key=lambda cell: cell.floor)
    healthy = [cell.healthy for cell in by_floor]
    assert healthy == sorted(healthy, key=lambda one: one or 0), "healthy data score as foretold"
    assert sensitivity.foretold(cells) == pytest.approx(1)
    for trend in sensitivity.trends(cells):
        scores = {cell.m: cell.global_score for cell in cells if cell.tau == trend.tau}
        assert trend.best == max(scores, key=lambda m: scores[m])
        passing = [m for m in (2, 5) if floors[m, trend.tau] <= 0.05]
        assert trend.passed == (max(passing) if passing else None)
    said = list(page.sensitivity_page("fleet", cells, True))
    assert any(line.startswith("  m = 5") for line in said)


@pytest.mark.parametrize(
    ("words", "refusal"),
    [
        (("table2", "--methods", "centriod"), "did you mean 'centroid'"),
        (("table2", "--methods", ","), "--methods is empty"),
        (("sensitivity", "--on", "plant"), "fleet or langevin"),
        (("recordings", "--data", ".", "--only", "plants"), "did you mean 'plant'"),
        (("recordings", "--data", "."), "--data takes their folder"),
    ],
)
def test_options_are_checked(words: tuple[str, ...], refusal: str) -> None:
    answer = invoked(*words)
    assert answer.exit_code == 1
    assert refusal in answer.stderr


def test_a_missing_library_is_said_before_anything_is_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)  # importing it raises
    answer = invoked("table2", "--quick", "--methods", "dse,mlp", "--results", str(tmp_path))
    assert answer.exit_code == 1
    assert 'This needs torch: pip install "gam-db[benchmark]"' in answer.stderr
    assert not list(tmp_path.iterdir())


def test_methods_keep_the_order_of_the_list() -> None:
    assert chosen("mlp, dse", []) == ["dse", "mlp"]
    assert chosen(None, ["gmm"]) == ["gmm"]
