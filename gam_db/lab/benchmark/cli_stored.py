"""``gam benchmark incremental|memory|stored|engines|alarms|programs``: stored form, engines, alarms."""

from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from gam_db.address import has_password, is_url
from gam_db.cli import options
from gam_db.errors import ConfigurationError, nearest
from gam_db.lab.benchmark import stored_report
from gam_db.lab.benchmark.alarms.cli import alarms, programs
from gam_db.lab.benchmark.cli import benchmark, chosen, counts, print_figures, shown
from gam_db.lab.benchmark.engines import EMBEDDED, EnginesPlan, measure_engines
from gam_db.lab.benchmark.incremental import IncrementalPlan, measure_incremental
from gam_db.lab.benchmark.memory import MemoryPlan, measure_memory
from gam_db.lab.benchmark.stored import StoredPlan, measure_stored
from gam_db.lab.benchmark.workload import ORDERS

ChannelsOption = Annotated[int, typer.Option(min=1, help="Channels of the workload.")]
RepeatOption = Annotated[int, typer.Option(min=1, help="Runs of each side.")]


def incremental(
    rows: Annotated[
        str, typer.Option(help="Rows of the smaller and of the larger history.")
    ] = "10000000,100000000",
    channels: ChannelsOption = 100,
    repeat: RepeatOption = 5,
    threads: options.Threads = None,
    as_json: options.Json = False,
) -> None:
    """Measure an hour of new rows after a little history, after much, and with a silent channel.

    Everything is simulated and stays in a temporary folder (about 1 GB at the default size).
    """
    sizes = counts("rows", rows)
    if len(sizes) != 2:
        raise ConfigurationError(
            f"--rows is {rows!r}; it takes two different numbers, such as 10000000,100000000."
        )
    plan = IncrementalPlan((sizes[0], sizes[1]), channels, repeat, threads)
    print_figures(
        shown(plan.runs, lambda on_run: measure_incremental(plan, on_run)),
        stored_report.incremental_lines,
        as_json,
    )


def memory(
    rows: Annotated[int, typer.Option(min=1, help="Rows of the telemetry.")] = 100_000_000,
    channels: ChannelsOption = 100,
    memory_limit: Annotated[str, typer.Option(help="DuckDB's memory_limit.")] = "1GB",
    threads: options.Threads = None,
    as_json: options.Json = False,
) -> None:
    """Measure scoring many rows from nothing with little memory.

    Everything is simulated and stays in a temporary folder (about 1 GB at the default size).
    """
    plan = MemoryPlan(rows, channels, memory_limit, threads)
    print_figures(
        shown(plan.runs, lambda on_run: measure_memory(plan, on_run)),
        stored_report.memory_lines,
        as_json,
    )


def stored(
    channels: ChannelsOption = 12,
    samples: Annotated[int, typer.Option(min=100, help="Samples per channel.")] = 1_000_000,
    repeat: RepeatOption = 3,
    threads: Annotated[str, typer.Option(help="Numbers of threads, with commas.")] = "1,2",
    order: Annotated[str, typer.Option(help=f"How rows lie: {', '.join(ORDERS)}.")] = "channel,time",
    as_json: options.Json = False,
) -> None:
    """Measure calibrating and scoring from nothing beside the exact form.

    Everything is simulated and stays in a temporary folder (about 1 GB at the default size).
    """
    plan = StoredPlan(
        channels,
        samples,
        repeat,
        tuple(counts("threads", threads)),
        tuple(chosen("order", order, list(ORDERS))),
    )
    print_figures(
        shown(plan.runs, lambda on_run: measure_stored(plan, on_run)),
        stored_report.stored_lines,
        as_json,
    )


def engines(
    addresses: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="[ENGINE]...",
            help=f"{', '.join(EMBEDDED)}, or an address such as postgresql://HOST/DATABASE, where "
            "tables are made and dropped again. Default: all those named here.",
        ),
    ] = None,
    channels: ChannelsOption = 12,
    samples: Annotated[int, typer.Option(min=100, help="Samples per channel.")] = 1_000_000,
    repeat: RepeatOption = 3,
    as_json: options.Json = False,
) -> None:
    """Measure gam-db inside each engine beside taking the rows out, and beside the engine's floor.

    Everything is simulated; what embedded engines hold stays in a temporary folder.
    """
    plan = EnginesPlan(tuple(addresses or EMBEDDED), channels, samples, repeat)
    for address in plan.engines:
        if address not in EMBEDDED and not is_url(address):
            raise ConfigurationError(f"There is no engine {address!r}{nearest(address, EMBEDDED)}")
        if has_password(address):
            raise ConfigurationError(
                "A password in an address would be seen by all who list processes; put it into the "
                "environment (PGPASSWORD, CLICKHOUSE_PASSWORD)."
            )
    print_figures(
        shown(plan.runs, lambda on_run: measure_engines(plan, on_run)),
        stored_report.engines_lines,
        as_json,
    )


class _Throughput(TyperGroup):
    """The measurements by name; ``gam benchmark`` without a name is ``gam benchmark throughput``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        if not args or (args[0] not in self.commands and args[0] not in ctx.help_option_names):
            args = ["throughput", *args]
        return super().parse_args(ctx, args)


benchmarks = typer.Typer(
    cls=_Throughput,
    add_completion=False,
    rich_markup_mode="markdown",
    help="Measure speed, memory and alarms of gam-db on this machine.",
)
benchmarks.command("throughput")(benchmark)
benchmarks.command()(stored)
benchmarks.command()(incremental)
benchmarks.command()(memory)
benchmarks.command()(engines)
benchmarks.command()(alarms)
benchmarks.command()(programs)
