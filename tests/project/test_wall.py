"""The wall round the laboratory, and what is loaded when: the core never imports the laboratory."""

import ast
import importlib
import shutil
import subprocess
import sys
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from typer.testing import CliRunner

import gam_db
from gam_db.cli import app, commands

PACKAGE = Path(gam_db.__file__).parent
#: Lower modules first; a module may import what stands in lines above its own, and its own package.
LAYERS = [
    ["columns", "data", "errors", "version"],
    ["address", "clock", "composing", "extras", "langevin"],
    ["settings", "units"],
    ["method"],
    ["engines"],
    ["reading"],
    ["study"],
    ["alarms", "checking", "health", "selection"],
    ["findings", "sklearn"],
    ["report"],
    ["stored.lengths", "stored.schema", "stored.sources"],
    ["stored.state"],
    ["stored.planning"],
    ["stored.alarms", "stored.calibrating", "stored.pruning"],
    ["stored.checking", "stored.settings"],
    ["stored.scoring", "stored.status"],
    ["stored.monitor"],
    ["gam_db"],
    ["export", "plot"],
    ["cli"],
    ["lab.estimators", "lab.evaluation", "lab.simulate"],
    ["lab.benchmark", "lab.baselines"],
    ["lab.reproduce"],
]

#: Rooms that hold rooms.
HALLS = ("gam_db.lab", "gam_db.stored")

#: Tests of the checkout as it is, and what is no test.
APART = ("project", "guard", "tools", "reference", "spec", "conftest.py")

HEAVY = ("duckdb", "numpy", "pyarrow", "sqlglot", "rich.console")


def loaded_by(code: str) -> set[str]:
    """Return the modules that a fresh process has loaded after some code."""
    told = "import sys; print('\\n' + ' '.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", f"{code}\n{told}"], check=True, capture_output=True, text=True
    )
    return set(done.stdout.splitlines()[-1].split())


def imported(source: str) -> Iterator[str]:
    """The rooms of gam_db that a module imports, wherever in its text; not for the type checker only."""
    tree = ast.parse(source)
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.If)
            and isinstance(node.test, ast.Name)
            and node.test.id == "TYPE_CHECKING"
        ):
            node.body = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level:
            raise AssertionError("relative import")
        elif isinstance(node, ast.ImportFrom) and node.module in ("gam_db", *HALLS):
            names = [f"{node.module}.{alias.name}" for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            names = [node.module or ""]
        else:
            continue
        for name in names:
            if name == "gam_db" or name.startswith("gam_db."):
                yield room(tuple(name.split(".")[1:]))


def room(parts: tuple[str, ...]) -> str:
    """The room of a module: its first name below gam_db, its first two where rooms lie in one."""
    return ".".join(parts[: 2 if f"gam_db.{parts[0]}" in HALLS else 1]) if parts else "gam_db"


def too_high(subject: str, source: str) -> list[str]:
    """The imports of a module that stand no lower than itself; a module without layer is a top one."""
    level = {name: number for number, names in enumerate(LAYERS) for name in names}
    own = level.get(subject, len(LAYERS))
    return [name for name in imported(source) if name != subject and level.get(name, len(LAYERS)) >= own]


def test_the_check_of_layers_finds_a_wrong_import() -> None:
    assert too_high("clock", "from gam_db.method import Method") == ["method"]
    assert too_high("composing", "def f():\n    import gam_db.cli.run") == ["cli"]
    assert too_high("settings", "from gam_db import units") == ["units"]
    assert too_high("reading", "import gam_db") == ["gam_db"]
    assert too_high("cli", "from gam_db.lab.evaluation import evaluate") == ["lab.evaluation"]
    assert too_high("stored.state", "from gam_db import lab") == ["lab"]
    assert too_high("stored.state", "from gam_db.stored import planning") == ["stored.planning"]
    assert not too_high("method", "from gam_db.composing import template\nimport numpy")


def test_lower_modules_do_not_import_higher_ones() -> None:
    """And so the core never imports the laboratory, whose rooms are the highest."""
    wrong = {}
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(PACKAGE).with_suffix("").parts
        subject = room(() if parts == ("__init__",) else parts)
        if found := too_high(subject, path.read_text(encoding="utf-8")):
            wrong[str(path.relative_to(PACKAGE))] = found
    assert not wrong


def read_by(path: Path) -> set[Path]:
    """The modules of gam_db that a module imports, wherever in its text, as files."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if not isinstance(node, ast.ImportFrom) or not (node.module or "").startswith("gam_db"):
            continue
        folder = PACKAGE.joinpath(*(node.module or "").split(".")[1:])
        for alias in node.names:
            places = (folder / f"{alias.name}.py", folder / alias.name / "__init__.py")
            own = (folder.with_suffix(".py"), folder / "__init__.py")
            found.add(next(place for place in (*places, *own) if place.is_file()))
    return found


def test_no_modules_import_one_another_in_a_circle() -> None:
    graph = {path: read_by(path) for path in PACKAGE.rglob("*.py")}
    assert len(list(TopologicalSorter(graph).static_order())) == len(graph)
    running = PACKAGE / "study" / "running.py"
    with pytest.raises(CycleError):
        TopologicalSorter({**graph, PACKAGE / "errors.py": {running}}).prepare()


def test_importing_loads_nothing_that_is_not_needed() -> None:
    assert not loaded_by("import gam_db").intersection(HEAVY)
    assert "numpy" in loaded_by("import gam_db; gam_db.Monitor"), "what is asked for is loaded"


@pytest.mark.parametrize("words", [["--version"], ["--help"]])
def test_help_reads_neither_the_laboratory_nor_sql(words: list[str]) -> None:
    code = f"from gam_db.cli import app\ntry:\n    app({words})\nexcept SystemExit:\n    pass"
    loaded = loaded_by(code)
    assert not {
        name for name in loaded if name.startswith("gam_db.lab") or name == "gam_db.composing.template"
    }
    assert not loaded.intersection(HEAVY[:-1])


def test_every_public_name_is_there() -> None:
    for name in gam_db.__all__:
        assert getattr(gam_db, name) is not None
        assert name in dir(gam_db)
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = gam_db.nothing  # type: ignore[attr-defined]


def test_every_command_is_listed_with_its_own_words() -> None:
    stand_ins = {command.name: command for command in commands.listed()}
    assert {entry.name for entry in commands.laboratory()} == set(commands.OF_LABORATORY)
    for name, stand_in in stand_ins.items():
        own = " ".join((commands.loaded(str(name)).help or "").split("\n\n")[0].split())
        assert own == stand_in.help, name


def test_help_shows_three_panels() -> None:
    shown = CliRunner().invoke(app, ["--help"]).stdout
    panels = [shown.index(f"─ {panel} ─") for panel in ("Watch", "Once", "Laboratory")]
    assert panels == sorted(panels)


def test_estimators_come_by_an_entry_point() -> None:
    (entry,) = entry_points(group="gam_db.estimators")
    assert importlib.import_module(entry.value) is entry.load()


@pytest.mark.full
def test_the_core_stands_without_the_laboratory(tmp_path: Path) -> None:
    """With its folders gone, all tests of the core pass but those of the project as a whole."""
    kept = copied(tmp_path / "core")
    for folder in ("gam_db", "sql", "tests"):
        shutil.rmtree(kept / folder / "lab")
    rooms = sorted(str(path) for path in (kept / "tests").iterdir() if path.name not in APART)
    words = ["-q", "-n", "2", "--engines", "duckdb", "-p", "no:cacheprovider", *rooms]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *words], cwd=kept, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout[-3000:]
    for words, said in (
        (["benchmark"], "gam benchmark is part of the laboratory"),
        (["run", "none.parquet", "--estimator", "forest"], "all but dse are part of the laboratory"),
    ):
        gam = [sys.executable, "-c", "from gam_db.cli import main; main()", *words]
        told = subprocess.run(gam, cwd=kept, capture_output=True, text=True)
        assert (told.returncode, told.stderr.count(said)) == (1, 1), told.stderr


def copied(folder: Path) -> Path:
    """Copy what git knows of the checkout, as it lies here."""
    root = PACKAGE.parent
    names = subprocess.run(
        ["git", "ls-files", "-co", "--exclude-standard"], cwd=root, check=True, capture_output=True
    ).stdout.decode()
    for name in names.splitlines():
        if (root / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(root / name, folder / name)
    return folder
