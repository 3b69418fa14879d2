"""What all tests share: which engines they run on, how many random cases, where the recordings lie."""

import gc
import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, settings
from hypothesis.internal.conjecture import providers

import begun
import engines
import sets
import tiny
from gam_db.engines import storage

gc.disable()  # until pytest_collection_finish, what is made stays
tiny.judge_any_calibration()
begun.begin_as_copies()

#: Counts what is compared with the NumPy reference.
pytest_plugins = ["comparisons"]

# One draw in twenty is a number that stands somewhere in the modules that a process has loaded so far:
# any other constant of the project, or another order of the tests, would draw other cases.
providers._get_local_constants = lambda: providers._local_constants
# The same cases in every run; more, and other ones, by HYPOTHESIS_PROFILE=many.
settings.register_profile(
    "few",
    max_examples=100,
    derandomize=True,
    deadline=None,
    database=None,
    # Looking for a smaller case takes minutes where each one runs a hundred statements.
    phases=(Phase.explicit, Phase.generate),
    suppress_health_check=[HealthCheck.too_slow],
)
settings.register_profile(
    "many", max_examples=2000, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "few"))


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--engines", default="fast", help="fast (DuckDB, SQLite), all, or names with commas between"
    )


def pytest_configure(config: pytest.Config) -> None:
    """Refuse engines that there are not, once, before anything is looked for."""
    engines.asked_for(config.getoption("--engines"))


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Leave the files alone whose engine nobody asked for; they need its libraries."""
    return engines.is_left_out(collection_path.name, config.getoption("--engines")) or None


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Run a test that has an argument ``engine`` on every engine that is asked for."""
    if "engine" in metafunc.fixturenames and not sets.names_engines(metafunc.definition):
        metafunc.parametrize("engine", engines.chosen(metafunc.config.getoption("engines")))


@pytest.hookimpl(tryfirst=True)  # before pytest looks at the marks
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what would take too long together, where all engines are asked for."""
    if config.getoption("--engines") == "all":
        for later in filter(sets.is_later, items):
            later.add_marker(pytest.mark.full)
    is_whole = config.args_source is pytest.Config.ArgsSource.TESTPATHS and not config.option.keyword
    plain = is_whole and config.option.markexpr == "not full"
    kept = engines.shortened(items, config.getoption("--engines"), plain)
    staying = set(kept)
    config.hook.pytest_deselected(items=[one for one in items if one not in staying])
    items[:] = kept


def pytest_collection_finish() -> None:
    """Keep the garbage collector off what stays: all modules, tests and parsed files of SQL.

    Walking through them again and again was a third of the processor time of small tests. What is made
    from now on is mostly trees of statements, which stand in circles: ten thousand objects still lie in
    the processor's cache when they are walked through, a hundred thousand cost ten times as much each.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(10_000, 5, 500)
    gc.enable()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Let the test have databases in memory of its own, and states begin as it wants it."""
    callspec = getattr(item, "callspec", None)
    engines.begin(callspec.params.get("engine") if callspec else None)
    begun.is_copied = item.get_closest_marker("migrates") is None


def pytest_unconfigure() -> None:
    """Let the process end as usual: DuckDB's binding tells at its end of what nobody collected."""
    gc.unfreeze()


@pytest.fixture(scope="session")
def recordings() -> Path:
    """The folder of the real recordings; without it the test says that it was left out."""
    folder = os.environ.get("GAM_TEST_DATA")
    if not folder:
        pytest.skip("left out: set GAM_TEST_DATA to the folder of the real recordings to run it")
    return Path(folder)


@pytest.fixture(autouse=True)
def without_comments(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Make the tables of a state without the comments of their columns, where no test is about them.

    They are nine of ten statements of a migration on PostgreSQL, and where DuckDB makes what is copied.
    """
    if request.node.get_closest_marker("migrates") is None:
        monkeypatch.setattr(storage, "_about", lambda *_: [])
