"""The wheel alone is enough: installed into an empty environment, outside the checkout."""

import subprocess
import sys
import venv
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_wheel_holds_the_sql_and_the_migrations_and_runs_the_demo(tmp_path: Path) -> None:
    subprocess.run(
        [sys.executable, "-m", "build", "--wheel", "--outdir", str(tmp_path), str(ROOT)],
        check=True,
        capture_output=True,
    )
    (wheel,) = tmp_path.glob("gam_db-*.whl")
    with zipfile.ZipFile(wheel) as packed:
        inside = set(packed.namelist())
    for folder in ("sql", "migrations"):
        files = {file.relative_to(ROOT) for file in (ROOT / folder).rglob("*.*") if file.is_file()}
        assert files
        assert {f"gam_db/{file.as_posix()}" for file in files} <= inside

    environment = tmp_path / "environment"
    venv.create(environment, with_pip=True)
    python = environment / "bin" / "python"
    subprocess.run(
        [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", str(wheel)],
        check=True,
        capture_output=True,
    )
    for words in (
        ["migrate", "--database", "plant.duckdb"],
        ["migrate", "--status", "--database", "plant.duckdb"],
    ):
        subprocess.run([str(environment / "bin" / "gam"), *words], cwd=tmp_path, check=True)
    demo = subprocess.run(
        [str(environment / "bin" / "gam"), "demo"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        text=True,
    )
    assert "verdicts: 1 ready" in demo.stdout
    assert "gam run" in demo.stdout
