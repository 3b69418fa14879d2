"""How `run.sql` ends: by an error where it must not count, and what is printed at all."""

import contextlib
import re
import subprocess
from pathlib import Path

import pytest
from sqlglot import exp
from typer.testing import CliRunner

import command_lines
import engines
import gam_db
import scripts
import test_run_sql as runs
from gam_db.cli import app
from gam_db.engines.session import Session
from gam_db.errors import UserError
from gam_db.export.monitor import rendered
from gam_db.stored.monitor import Monitor

pytestmark = pytest.mark.thorough

# Who is faster, and what must not count


def plant(engine: str, folder: Path) -> tuple[Session, Monitor, str]:
    """Return a monitor that has scored, with new rows in its source, and the script of its next run."""
    session = command_lines.opened(engine, folder)
    rows = [
        (asset, "x", time, float(time % (5 + n))) for n, asset in enumerate("ab") for time in range(90)
    ]
    table = scripts.telemetry(session, rows)
    place, prefix = gam_db.Source(table.name), engines.fresh_name("plant")
    monitor = Monitor(session, place, *runs.METHOD, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    scripts.arrive(session, table, [("a", "x", time, float(time % 11)) for time in range(90, 140)])
    return session, monitor, rendered(monitor)


def refused(engine: str, folder: Path, session: Session, script: str) -> str:
    """Execute a script by the command line as it is documented, and return how it ended."""
    path = folder / "run.sql"
    path.write_text(script, encoding="utf-8")
    if engine == "duckdb":  # which one process opens at a time
        session.connection.close()  # type: ignore[attr-defined]
    with path.open("rb") as read:
        words = command_lines.words(engine, folder, path)
        ended = subprocess.run(words, stdin=read, capture_output=True)
    assert ended.returncode != 0
    return ended.stderr.decode()


def test_a_faster_run_ends_the_script_and_nothing_of_it_counts(engine: str, tmp_path: Path) -> None:
    if runs.is_refused(engine):
        return
    session, monitor, script = plant(engine, tmp_path)
    tables = monitor.tables
    columns = [name for name in session.relations()[tables.folded("run")] if name != "run_id"]
    newest = exp.select(exp.Max(this=exp.column("run_id")).as_("newest")).from_(tables.table("run"))
    rows = exp.select((exp.column("run_id") + 1).as_("run_id"), *columns).from_(tables.table("run"))
    rows = rows.where(exp.column("run_id").eq(newest.subquery()))
    names = [exp.to_identifier(name) for name in ("run_id", *columns)]
    faster = exp.Insert(this=exp.Schema(this=tables.table("run"), expressions=names), expression=rows)
    before = runs.stored(monitor)
    begin = "-- Publish"
    assert script.count(begin) == 1
    raced = script.replace(begin, f"{session.engine.text(faster)};\n{begin}")
    said = refused(engine, tmp_path, session, raced)
    assert "Another process scored, calibrated or pruned" in said
    if engine == "duckdb":
        session = command_lines.opened(engine, tmp_path)
        monitor = Monitor(session, monitor.source, *runs.METHOD, prefix=tables.prefix)
    after = runs.stored(monitor)
    assert len(after["run"]) == len(before["run"]) + 2, "those of the faster one are there"
    for name in runs.TABLES.keys() - {"run"}:
        assert after[name] == before[name], name
    runs.executed(engine, tmp_path, session, script)
    assert len(runs.stored(monitor)["bucket"]) > len(before["bucket"])
    session.close()


def test_other_settings_and_damage_end_the_script(engine: str, tmp_path: Path) -> None:
    if runs.is_refused(engine):
        return
    session, monitor, script = plant(engine, tmp_path)
    other = gam_db.Parameters(m=3, tau=3, bins=4, window=20, stride=5)
    given = session, monitor.source, other, runs.METHOD[1]
    Monitor(*given, prefix=monitor.tables.prefix).calibrate()
    before = runs.stored(monitor)
    ended = command_lines.executed(engine, tmp_path, session, script)
    assert ended.returncode != 0
    assert b"settings that this script was not made for" in ended.stderr
    script = rendered(monitor)
    support = monitor.tables.table("support")
    session.execute(exp.update(support, {"visits": exp.column("visits") + 1}))
    ended = command_lines.executed(engine, tmp_path, session, script)
    assert ended.returncode != 0
    assert b"was changed or damaged" in ended.stderr
    assert runs.stored(monitor) == before
    session.close()


# What is printed, and the page


def test_the_command_prints_it_and_the_line_of_cron_runs_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    session, monitor, script = plant("sqlite", tmp_path)
    asked = ["compile", "--form", "monitor", "--database", "sqlite:///plant.db"]
    prefix = ["--prefix", monitor.tables.prefix]
    ended = CliRunner().invoke(app, [*asked, *prefix, "--out", "run.sql"])
    assert ended.exit_code == 0, ended.output
    assert (tmp_path / "run.sql").read_text(encoding="utf-8") == script
    page = Path(__file__).parents[2] / "docs" / "schedule.md"
    text = page.read_text(encoding="utf-8")
    assert command_lines.OF_DUCKDB in text
    lines = re.findall(r"^\*/15 \* \* \* \* (.*)$", text, re.MULTILINE)
    (line,) = (one for one in lines if one.startswith("sqlite3 "))
    line = line.replace("/srv/plant/", f"{tmp_path}/")
    before = len(runs.stored(monitor)["bucket"])
    done = subprocess.run(["sh", "-c", line], capture_output=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, b"", b"")
    assert len(runs.stored(monitor)["bucket"]) > before
    for more, said in (
        (["telemetry"], "leave out SOURCE"),
        (["--engine", "postgres"], "leave out --engine postgres"),
    ):
        ended = CliRunner().invoke(app, [*asked, *prefix, *more])
        assert ended.exit_code == 1
        assert said in ended.output
    session.close()


def test_what_cannot_be_printed_is_said(tmp_path: Path) -> None:
    path = tmp_path / "telemetry.csv"
    path.write_text("asset,channel,time,value\n" + "".join(f"a,x,{n},{n % 5}\n" for n in range(60)))
    with contextlib.closing(command_lines.opened("duckdb", tmp_path)) as session:
        monitor = Monitor(session, gam_db.Source(path), *runs.METHOD)
        monitor.migrate()
        with pytest.raises(UserError, match="There is no monitor"):
            rendered(monitor)
        monitor.calibrate()
        with pytest.raises(UserError, match="not a table or view of its database"):
            rendered(monitor)
