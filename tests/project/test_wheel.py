"""The wheel alone is enough: installed into an empty environment, outside the checkout."""

import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

from sets import amounts

pytestmark = pytest.mark.thorough

ROOT = Path(__file__).parents[2]


@amounts("apart", False, True)
def test_the_wheel_holds_the_sql_and_the_migrations_and_runs_the_demo(
    tmp_path: Path, apart: bool
) -> None:
    """With what it needs taken from here, or with all of it built and installed anew."""
    here = [] if apart else ["--no-isolation"]
    subprocess.run(
        [sys.executable, "-m", "build", "--wheel", *here, "--outdir", str(tmp_path), str(ROOT)],
        check=True,
        capture_output=True,
    )
    (wheel,) = tmp_path.glob("gam_db-*.whl")
    with zipfile.ZipFile(wheel) as packed:
        inside = set(packed.namelist())
    assert "gam_db/py.typed" in inside
    for folder in ("sql", "migrations"):
        files = {file.relative_to(ROOT) for file in (ROOT / folder).rglob("*.*") if file.is_file()}
        assert files
        assert {f"gam_db/{file.as_posix()}" for file in files} <= inside

    environment = tmp_path / "environment"
    venv.create(environment, with_pip=True)
    python = environment / "bin" / "python"
    words = ["install", "--quiet", "--disable-pip-version-check", str(wheel)]
    if not apart:
        words.append("--no-deps")
        (site,) = (environment / "lib").glob("python*/site-packages")
        (site / "needed.pth").write_text(sysconfig.get_path("purelib"))
    subprocess.run([str(python), "-m", "pip", *words], check=True, capture_output=True)
    for asked in ((), ("--status",)):
        command = [str(environment / "bin" / "gam"), "migrate", *asked, "--database", "plant.duckdb"]
        subprocess.run(command, cwd=tmp_path, check=True)
    demo = subprocess.run(
        [str(environment / "bin" / "gam"), "demo"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        text=True,
    )
    assert "verdicts: 1 ready" in demo.stdout
    assert "gam run" in demo.stdout
