"""Other DuckDBs than the one that is installed: folders that hold one each, named by ``GAM_DUCKDBS``."""

import functools
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]

#: Folders of the oldest and the newest version that are allowed, as docs/engines.md says.
FOLDERS = [*filter(None, os.environ.get("GAM_DUCKDBS", "").split(os.pathsep))]


def run(folder: str, *words: str) -> subprocess.CompletedProcess[str]:
    """Run Python with the DuckDB of a folder; an empty name is the installed one."""
    around = {**os.environ, "PYTHONPATH": folder}
    return subprocess.run([sys.executable, *words], cwd=ROOT, env=around, capture_output=True, text=True)


@functools.cache
def version(folder: str) -> str:
    """Return the version that a folder holds."""
    return run(folder, "-c", "import duckdb; print(duckdb.__version__)").stdout.strip()
