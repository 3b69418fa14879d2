"""Alarms on recordings: which labelled faults are seen, how early, and which healthy channels open.

Run by hand: ``GAM_TEST_DATA=FOLDER python -m tests.tools.recorded_alarms [NAME]...``; the folder holds
the recordings, each with series.parquet and labels.parquet. Nobody labelled false alarms on machines
that ran to failure, so only healthy recordings say how often nothing was wrong.
"""

import os
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from pyarrow import parquet

from gam_db.alarms import Alarms
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.benchmark.alarms.tables import Judged, Pool, Row, learnt, name_of
from gam_db.settings.source import Source
from watched_recordings import RECORDINGS, Recording

RATES = ("1 per 1000 judgements", "0.5 per 1000 judgements")


def lines(name: str, recording: Recording, folder: Path) -> Iterator[str]:
    """Yield what alarms do on a recording, at each rate."""
    place = folder / recording.folder
    source = Source(place / "series.parquet", time=recording.time)
    tables = learnt(source, recording.parameters, recording.calibration)
    labels = parquet.read_table(place / "labels.parquet").to_pylist()
    with DuckSession() as session:
        pool = Pool(session, [tables])
        windows = pool.tables["judged_windows"].to_pylist()
        for rate in RATES:
            judged = pool.judged(Alarms(rate=rate, family=recording.family))
            yield f"{name}, {rate}: {_limits(judged)}"
            if recording.faults:
                yield from _faults(judged, labels, recording.faults, windows, pool)
            else:
                yield from _healthy(judged)


def _limits(judged: Judged) -> str:
    bases = Counter(row["basis"] for row in judged.limits if row["reason"] is None)
    reasons = Counter(row["reason"] for row in judged.limits if row["reason"] is not None)
    return (
        f"{len(judged.limits)} channels; limits: {_counts(bases)}; without: {_counts(reasons)}; "
        f"{sum(row['episodes'] for row in judged.counted)} episodes in "
        f"{sum(row['judgements'] for row in judged.counted):,} judgements"
    )


def _healthy(judged: Judged) -> Iterator[str]:
    for row in judged.limits:
        row["episodes"] = 0
    limits = {name_of(row): row for row in judged.limits}
    for row in judged.counted:
        limits[name_of(row)] |= {name: row[name] for name in ("episodes", "judgements")}
    opened = [row for row in judged.limits if row["episodes"]]
    for row in opened:
        ratio = "-" if row["order_ratio"] is None else f"{row['order_ratio'] / 1000:.2f}"
        yield (
            f"  opens: {row['asset']} {row['channel']}, {row['episodes']} in {row['judgements']} "
            f"judgements; basis {row['basis']}, order ratio {ratio}, {row['blocks']} blocks"
        )
    told = [f"{row['asset']} {row['channel']}" for row in judged.limits if _is_unlike(row)]
    yield f"  called unrepresentative by calibration alone: {', '.join(told) or 'none'}"


def _is_unlike(row: Row) -> bool:
    return bool(row["reason"] == "unrepresentative")


def _faults(
    judged: Judged, labels: list[Row], faults: tuple[str, ...], windows: list[Row], pool: Pool
) -> Iterator[str]:
    names = {row["channel_id"]: name_of(row) for row in pool.tables["channels"].to_pylist()}
    begins: dict[str, int] = {}
    for row in windows:
        asset = names[row["channel_id"]][0]
        begins[asset] = min(begins.get(asset, row["first_time"]), row["first_time"])
    for asset in sorted({row["asset"] for row in labels if row["event"] in faults}):
        spans = [row for row in labels if row["asset"] == asset and row["event"] in faults]
        spans = [row for row in spans if row["end"] > begins.get(asset, row["end"])]
        its = [row for row in judged.limits if row["asset"] == asset and row["reason"] is None]
        for fault in faults:
            of_fault = [(row["start"], row["end"]) for row in spans if row["event"] == fault]
            if not of_fault:
                continue
            opened: dict[str, int] = {}
            for row in judged.episodes:
                if row["asset"] == asset and any(
                    row["first_time"] <= end and start <= row["last_time"] for start, end in of_fault
                ):
                    opened.setdefault(row["channel"], row["first_time"])
            begin, end = begins[asset], of_fault[0][1]
            early = ", ".join(
                f"{channel} at {max(0.0, (time - begin) / (end - begin)):.2f}"
                for channel, time in sorted(opened.items(), key=lambda one: one[1])[:6]
            )
            yield (
                f"  {asset} {fault}: an episode lasts into it on {len(opened)} of {len(its)} judged "
                f"channels; opened, as a share of the time from calibration to it: {early or '-'}"
            )


def _counts(counted: Counter[str]) -> str:
    return ", ".join(f"{name} {count}" for name, count in sorted(counted.items())) or "none"


if __name__ == "__main__":
    data = Path(os.environ["GAM_TEST_DATA"])
    for chosen in sys.argv[1:] or RECORDINGS:
        for line in lines(chosen, RECORDINGS[chosen], data):
            print(line, flush=True)
