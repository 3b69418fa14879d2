"""No message, traceback or file shows a password, whatever the form of an address, right or wrong."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from gam_db.cli import app, commands
from gam_db.cli.exits import Exit

SECRET = "Zq9w0rd"

#: Every form of an address in which a password may stand, where it belongs and where it does not.
#: Nothing listens on port 1, and .invalid is no name of a host.
ADDRESSES = (
    f"postgresql://me:{SECRET}@127.0.0.1:1/plant",
    f"postgresql://me:{SECRET}@host.invalid/plant",
    f"postgresql://me:a@{SECRET}@127.0.0.1:1/plant",
    f"postgresql://me:a/{SECRET}@127.0.0.1:1/plant",
    f"postgresql://127.0.0.1:1/plant?user=me&password={SECRET}",
    f"postgres://me:{SECRET}@[::1:1/plant",
    f"clickhouse://me:{SECRET}@127.0.0.1:1/plant",
    f"clickhouses://me:{SECRET}@127.0.0.1:1/plant",
    f"clickhouse://me:{SECRET}@127.0.0.1:one/plant",
    f"clickhouse://127.0.0.1:1/plant?password={SECRET}",
    f"mariadb://me:{SECRET}@127.0.0.1:1/plant",
    f"mariadb://me:{SECRET}@127.0.0.1:one/plant",
    f"mariadb://127.0.0.1:1/plant?password={SECRET}",
    f"sqlite://me:{SECRET}@host/plant",
    f"sqlite:///plant.db?password={SECRET}",
    f"duckdb://me:{SECRET}@host/plant",
    f"duckdb:///plant.duckdb?password={SECRET}",
    f"chdb://me:{SECRET}@host/plant",
    f"spark://me:{SECRET}@host:7077/plant",
    f"sc://me:{SECRET}@127.0.0.1:1",
    f"sc://127.0.0.1:1/;use_ssl=true;token={SECRET}",
    f"sc://127.0.0.1:one/;token={SECRET}",
    f"mysql://me:{SECRET}@host/plant",
    f"host=127.0.0.1 port=1 dbname=plant password={SECRET}",
    f"dbname=plant user=me password='{SECRET}'",
)

#: command -> what else it is given, so that it comes as far as the address
WORDS: dict[str, tuple[str, ...]] = {
    "check": ("telemetry",),
    "init": ("telemetry",),
    "migrate": (),
    "calibrate": ("telemetry",),
    "score": ("telemetry",),
    "status": (),
    "report": (),
    "prune": ("--keep", "30 d"),
    "drop": ("--yes",),
    "run": ("telemetry",),
    "select": ("telemetry",),
    "compile": ("telemetry", "--engine", "duckdb"),
    "export": ("dbt", "telemetry", "--engine", "duckdb"),
    "alarms": (),
    "alarm": ("1",),
    "label": ("1", "true_fault"),
    "limits": (),
    "backtest": ("telemetry",),
    "evaluate": ("telemetry", "telemetry"),
}


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("GAM_DATABASE", raising=False)
    return tmp_path


def said(*words: str) -> str:
    """Run a command, and return all that it printed; it must refuse the address."""
    result = CliRunner().invoke(app, words)
    assert result.exit_code in (Exit.USER_ERROR, Exit.RUN_AGAIN), (words, result.output)
    return result.output


def with_database() -> Iterator[str]:
    """The commands that take an address."""
    for name in commands.MODULES:
        command = commands.loaded(name)
        many = getattr(command, "commands", {name: command}).values()
        if any("--database" in getattr(one, "opts", ()) for each in many for one in each.params):
            yield name


def test_every_command_that_takes_an_address_is_tried() -> None:
    assert set(with_database()) <= set(WORDS)


@pytest.mark.parametrize("command", sorted(with_database()))
def test_no_command_shows_a_password(command: str, folder: Path) -> None:
    for address in ADDRESSES:
        for debug in ((), ("--debug",)):
            answer = said(command, *WORDS[command], *debug, "--database", address)
            assert SECRET not in answer, address
            assert "Usage:" not in answer, "it comes as far as the address"
    (folder / "gam.toml").write_text(f'[source]\ndatabase = "{ADDRESSES[0]}"\n')
    assert SECRET not in said(command, *WORDS[command], "--debug")
    assert SECRET not in "".join(path.read_text() for path in folder.iterdir() if path.suffix != ".toml")


@pytest.mark.parametrize("address", ADDRESSES)
def test_an_address_in_the_place_of_something_else_is_shown_without_it(address: str) -> None:
    for words in (("run", address), ("migrate", address), ("check", address), ("nonsense", address)):
        assert SECRET not in said(*words, "--debug"), words


def test_an_address_in_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for address in ADDRESSES:
        monkeypatch.setenv("GAM_DATABASE", address)
        assert SECRET not in said("status", "--debug"), address
