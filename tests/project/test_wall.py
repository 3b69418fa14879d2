"""The wall round the laboratory, and what is loaded when: the core never imports the laboratory."""

import ast
import importlib
import re
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
from gam_db.cli.exits import MEANINGS

PACKAGE = Path(gam_db.__file__).parent
#: Lower modules first; one may import what stands in lines above its own, and its own room. Where a room
#: is a hall, the modules in it are told apart, and its name alone is what stands at its entrance.
LAYERS = [
    ["columns", "data", "plot", "sklearn", "version"],
    ["errors"],
    ["address", "arguments", "clock", "extras", "langevin", "composing.template"],
    ["composing.folding", "composing.layout", "composing.selects"],
    ["composing.joining"],
    ["composing.tidy"],
    ["composing.brief"],
    ["composing.pipeline", "settings.local_time", "settings.setting"],
    ["composing.plan"],
    ["settings.form", "units"],
    ["settings.calibration", "settings.parameters"],
    ["settings.patterns"],
    ["settings.source"],
    ["settings.local_rows"],
    ["method"],
    ["engines"],
    ["reading.undated"],
    ["alarms.heights", "reading.ahead", "reading.look", "reading.words", "study.running"],
    ["reading.guess", "reading.preparing"],
    ["study.streamed"],
    ["study.automatic", "study.census", "study.naming", "study.narrowing", "study.steps"],
    ["study.streaming"],
    ["study"],
    ["alarms", "checking", "health", "selection"],
    ["alarms.advising", "alarms.backtesting", "findings"],
    ["alarms.figures"],
    ["report"],
    ["stored.lengths", "stored.problems", "stored.schema", "stored.sources"],
    ["stored.state"],
    ["stored.planning"],
    ["stored.alarms", "stored.pruning"],
    ["stored.draft"],
    ["stored.calibrating"],
    ["stored.checking", "stored.settings"],
    ["stored.scoring", "stored.status"],
    ["stored.monitor"],
    ["gam_db"],
    ["export"],
    ["cli"],
    ["lab.estimators", "lab.evaluation", "lab.plot", "lab.simulate", "lab.sklearn"],
    ["lab.benchmark", "lab.baselines"],
    ["lab.reproduce"],
]

HALLS = ("alarms", "composing", "lab", "reading", "settings", "stored", "study")

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


def imported(source: str) -> Iterator[Path]:
    """The modules of gam_db that a module imports, wherever in its text, as files."""
    for node in ast.walk(ast.parse(source)):
        assert not (isinstance(node, ast.ImportFrom) and node.level), "relative import"
        if isinstance(node, ast.ImportFrom):
            asked = [(node.module or "", f".{alias.name}") for alias in node.names]
        elif isinstance(node, ast.Import):
            asked = [(alias.name, "") for alias in node.names]
        else:
            continue
        for module, name in asked:
            if module.split(".")[0] == "gam_db":
                found = [place for one in (module + name, module) for place in places(one)]
                yield next(place for place in found if place.is_file())


def places(module: str) -> tuple[Path, Path]:
    """Where the file of a module may be."""
    path = PACKAGE.joinpath(*module.split(".")[1:])
    return path.with_suffix(".py"), path / "__init__.py"


def room(path: Path) -> str:
    """The room of a module: its first name below gam_db, in a hall its first two."""
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    parts = parts[:-1] if parts[-1] == "__init__" else parts
    return ".".join(parts[: 2 if parts[:1] and parts[0] in HALLS else 1]) or "gam_db"


def too_high(subject: str, source: str) -> list[str]:
    """The imports of a module that stand no lower than itself; a module without layer is a top one."""
    level = {name: number for number, names in enumerate(LAYERS) for name in names}
    own = level.get(subject, len(LAYERS))
    rooms = map(room, imported(source))
    return [name for name in rooms if name != subject and level.get(name, len(LAYERS)) >= own]


def test_the_check_of_layers_finds_a_wrong_import() -> None:
    assert too_high("clock", "from gam_db.method import Method") == ["method"]
    assert too_high("composing.template", "def f():\n    import gam_db.cli.once") == ["cli"]
    assert too_high("settings.parameters", "from gam_db.settings import calibration") == [
        "settings.calibration"
    ]
    assert too_high("settings.source", "import gam_db") == ["gam_db"]
    assert too_high("study.running", "from gam_db.study import Study") == ["study"]
    assert too_high("cli", "from gam_db.lab.evaluation import evaluate") == ["lab.evaluation"]
    assert too_high("stored.state", "from gam_db.lab.simulate import cli") == ["lab.simulate"]
    assert too_high("stored.state", "from gam_db import lab") == ["lab"]
    assert too_high("stored.state", "from gam_db.stored import planning") == ["stored.planning"]
    assert not too_high("method", "from gam_db.composing import template\nimport numpy")


def test_lower_modules_do_not_import_higher_ones() -> None:
    """And so the core never imports the laboratory, whose rooms are the highest."""
    texts = {path: path.read_text(encoding="utf-8") for path in PACKAGE.rglob("*.py")}
    wrong = {path: too_high(room(path), text) for path, text in texts.items()}
    assert {str(path.relative_to(PACKAGE)): found for path, found in wrong.items() if found} == {}


def test_no_modules_import_one_another_in_a_circle() -> None:
    paths = list(PACKAGE.rglob("*.py"))
    graph = {path: set(imported(path.read_text(encoding="utf-8"))) for path in paths}
    assert len(list(TopologicalSorter(graph).static_order())) == len(graph)
    graph[PACKAGE / "errors.py"] = {PACKAGE / "study" / "running.py"}
    with pytest.raises(CycleError):
        TopologicalSorter(graph).prepare()


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


@pytest.mark.parametrize("name", ["plot", "sklearn"])
def test_a_public_module_of_the_laboratory_is_imported_when_it_is_used(name: str) -> None:
    """It lists the public names where a type checker looks, and each is there."""
    stub = (PACKAGE / f"{name}.pyi").read_text(encoding="utf-8")
    names = re.findall(rf"^from gam_db\.lab\.{name} import (\w+) as \1$", stub, re.MULTILINE)
    assert len(names) == stub.count("import ") > 0
    assert not any(one.startswith("gam_db.lab") for one in loaded_by(f"import gam_db.{name}"))
    code = f"from gam_db.{name} import {', '.join(names)}"
    assert f"gam_db.lab.{name}" in loaded_by(code)


def test_every_public_name_is_there() -> None:
    for name in gam_db.__all__:
        assert getattr(gam_db, name) is not None
    assert dir(gam_db) == sorted(gam_db.__all__), "and no others"
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        _ = gam_db.nothing  # type: ignore[attr-defined]


def test_every_command_is_listed_with_its_own_words() -> None:
    stand_ins = {command.name: command for command in commands.listed()}
    assert {entry.name for entry in commands.laboratory()} == set(commands.OF_LABORATORY)
    for name, stand_in in stand_ins.items():
        own = " ".join((commands.loaded(str(name)).help or "").split("\n\n")[0].split())
        assert own == stand_in.help, name


def test_help_shows_three_panels_on_one_screen() -> None:
    shown = CliRunner().invoke(app, ["--help"], env={"COLUMNS": "80"}).stdout
    panels = [shown.index(f"\n{panel}:\n") for panel in ("Watch", "Once", "Laboratory", "Options")]
    assert panels == sorted(panels)
    lines = shown.splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 80
    for stand_in in commands.listed():
        (line,) = [line for line in lines if line.split()[:1] == [stand_in.name]]
        assert line.endswith(f"  {(stand_in.help or '')}")
    assert {f"{code:d} {text}" for code, text in MEANINGS.items()} <= set(
        " ".join(lines[-2:]).removeprefix("Exit codes: ").removesuffix(".").split(", ")
    )


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
