"""Progress in words: each step that a command runs has a stage that a user knows."""

import ast
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import gam_db
from gam_db import data
from gam_db.cli import app
from gam_db.cli.progress import Progress, stage
from gam_db.composing.template import sql_folder

STAGES = data.table("gam_db.cli", "stages.toml")
SMALL = ("--m", "2", "--tau", "1", "--bins", "8", "--window", "50")


def test_every_folder_of_steps_has_a_stage() -> None:
    folders = {path.parent.relative_to(sql_folder()).as_posix() for path in sql_folder().rglob("*.sql")}
    assert set(STAGES["folders"]) == folders
    assert {stage(path.stem) for path in sql_folder().rglob("*.sql")} <= {
        text for part in STAGES.values() for text in part.values()
    }
    assert stage("cells_1_2") == stage("cells") == "testing the calibration"
    assert stage("writing the page") == "writing the page"
    assert stage("no_such_step") == "working"


def test_every_step_that_is_named_in_code_has_a_stage() -> None:
    for path in Path(gam_db.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "on_step":
                for step in [part.value for part in node.args if isinstance(part, ast.Constant)]:
                    assert stage(str(step)) != "working", (path, step)


def test_every_step_of_the_commands_has_a_stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    steps = set[str]()
    monkeypatch.setattr(Progress, "on_step", lambda _, step: steps.add(step))
    random = np.random.default_rng(7)
    times = np.tile(np.arange(1200), 2)
    columns = {
        "asset": np.repeat(["a", "b"], 1200),
        "channel": ["c"] * 2400,
        "time": times,
        "value": np.sin(times / 7) + (times > 900) + random.normal(size=2400) / 20,
        "product": np.where(times // 100 % 2, "p", "q"),
    }
    parquet.write_table(pa.table(columns), "x.parquet")
    state = ("--database", "state.duckdb")
    lines: list[tuple[Any, ...]] = [
        ("check", "x.parquet"),
        ("run", "x.parquet", "--no-out"),
        ("run", "x.parquet", *SMALL, "--program", "product", "--pool", "channel"),
        ("select", "x.parquet", "--m-max", "2", "--references", "50"),
        ("calibrate", "x.parquet", *SMALL, "--program", "product", *state),
        ("score", *state),
        ("check", "--state", *state),
        ("report", *state),
    ]
    for words in lines:
        answer = CliRunner().invoke(app, list(words))
        assert answer.exit_code in (0, 2, 4), (words, answer.output)
    assert {step for step in steps if stage(step) == "working"} == set()
    assert {stage(step) for step in steps} > {
        "reading the source",
        "learning the healthy states",
        "counting novel vectors",
        "writing results",
    }
