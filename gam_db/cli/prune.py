"""``gam prune`` and ``gam compact``: rows of the state go, and what is left of each channel is said.

This module owns the commands and their page; :mod:`gam_db.stored.pruning` does the work.
"""

import json
from collections.abc import Iterator
from typing import Annotated, Any

import pyarrow as pa
import pyarrow.compute as pc
import typer
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

import gam_db
from gam_db.cli import monitor_options, options, report
from gam_db.stored.pruning import COUNTED, NOVEL_ROWS, Retention
from gam_db.stored.pruning import compact as compacted
from gam_db.stored.pruning import prune as pruned

_LENGTHS = "seconds or a text like '90 d'; steps of a counter"
_KINDS = dict(zip(COUNTED, ("buckets", "novel cells", "runs", "support"), strict=True))


def prune(
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    keep: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH", help=f"Age up to which buckets stay: {_LENGTHS}. Default: all of them."
        ),
    ] = None,
    keep_novel: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help=f"The same for novel cells. Default: the newest {NOVEL_ROWS:,} of each version, so "
            "that a saturated channel does not grow without bound.",
        ),
    ] = None,
    keep_versions: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=0, help="Retired versions of each channel that stay. Default: all of them."
        ),
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would go, and change nothing.")
    ] = False,
    everything: Annotated[
        bool,
        typer.Option("--all", help=f"Print every channel, not only the {report.SHOWN} largest."),
    ] = False,
    as_json: monitor_options.JsonOption = False,
) -> None:
    """Delete old buckets, novel cells, versions and records of runs; say how large each channel is.

    Age is counted from the newest bucket of each channel. What the next run needs stays whatever its
    age: the buckets that lookback reaches, and a window before them. The file does not shrink; the room
    is used again.
    """
    session, tables, settings = monitor_options.opened(
        file=config, database=database, name=name, schema=schema, prefix=prefix, must_exist=True
    )
    said = settings.monitor
    retention = Retention(
        keep=said.keep if keep is None else options.length(keep),
        keep_novel=said.keep_novel if keep_novel is None else options.length(keep_novel),
        keep_versions=keep_versions,
        lookback=said.lookback,
    )
    with session:
        sizes = pruned(session, tables, said.name, retention, dry_run)
    tell(sizes, said.name, dry_run, everything, as_json)


def compact(
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    everything: Annotated[
        bool,
        typer.Option("--all", help=f"Print every channel, not only the {report.SHOWN} largest."),
    ] = False,
    as_json: monitor_options.JsonOption = False,
) -> None:
    """Delete rows that nobody sees: hidden by a later run, or left by one that was cut short.

    For engines without transactions (ClickHouse, Spark), where scoring only appends; on the others it
    finds nothing. The indicator does not change.
    """
    session, tables, settings = monitor_options.opened(
        file=config, database=database, name=name, schema=schema, prefix=prefix, must_exist=True
    )
    with session:
        sizes = compacted(session, tables, settings.monitor.name)
    tell(sizes, settings.monitor.name, False, everything, as_json)


def tell(sizes: pa.Table, monitor: str, dry_run: bool, everything: bool, as_json: bool) -> None:
    """Print how much there was and is of each channel."""
    if as_json:
        figures = {
            "version": gam_db.__version__,
            "monitor": monitor,
            "dry_run": dry_run,
            "channels": sizes.to_pylist(),
            "exit_code": 0,
        }
        print(json.dumps(figures, ensure_ascii=False, indent=1))
        return
    out = report.console()
    shown = sizes if everything else sizes.slice(0, report.SHOWN)
    for text in _lines(out, shown.to_pylist()):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    if sizes.num_rows > shown.num_rows:
        report.say(out, f"and {sizes.num_rows - shown.num_rows:,} smaller channels; --all")
    out.print()
    report.say(out, _summary(sizes, dry_run))


def _lines(out: Console, rows: list[dict[str, Any]]) -> Iterator[Text]:
    """Yield a line per channel with the rows that are left, and of those that there were."""
    names = [report.printable(f"{row['asset']} {row['channel']}") for row in rows]
    cells = [[_left(row[f"{kind}_after"], row[kind]) for kind in COUNTED] for row in rows]
    widths = [
        max([len(heading), *(len(row[place]) for row in cells)])
        for place, heading in enumerate(_KINDS.values())
    ]
    free = out.width - sum(widths) - 2 * len(widths)
    width = min(max([7, *map(cell_len, names)]), max(7, free))
    styles = ["bold", *[""] * len(rows)]
    table = zip(["channel", *names], [list(_KINDS.values()), *cells], styles, strict=True)
    for name, row, style in table:
        counts = "".join(f"  {cell:>{wide}}" for cell, wide in zip(row, widths, strict=True))
        yield Text(report.fit(name, width) + counts, style)


def _left(after: int, before: int) -> str:
    return f"{after:,}" if after == before else f"{after:,} of {before:,}"


def _summary(sizes: pa.Table, dry_run: bool) -> str:
    gone = []
    for kind, word in _KINDS.items():
        count = (pc.sum(sizes[kind]).as_py() or 0) - (pc.sum(sizes[f"{kind}_after"]).as_py() or 0)
        if count:
            gone.append(f"{count:,} rows of {word}")
    versions = pc.sum(pc.subtract(sizes["versions"], sizes["versions_after"])).as_py()
    if versions:
        gone.append(f"{versions:,} versions")
    if not gone:
        return "nothing to delete"
    return f"{'would delete' if dry_run else 'deleted'}: {', '.join(gone)}"
