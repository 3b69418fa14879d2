"""The same table on real machines that ran to failure: a production plant, and bearings on a rig.

Which channel of a plant's component shows wear is not known, so none is chosen: every channel is
evaluated over the assets that failed, and what is printed is the mean over the channels. A channel that
did not move while it was calibrated cannot be judged and is left out. No healthy control was recorded,
so there is no discriminability, and Global is the mean of the other four.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from pyarrow import parquet

from gam_db.errors import SourceError
from gam_db.health import support
from gam_db.lab.reproduce.evaluated import SURROGATES, summary
from gam_db.lab.reproduce.methods import METHODS, Task, check_libraries, health
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source

CALIBRATION = 0.2
METRICS = ("mon", "corr", "rob", "prog", "global")
CHANCE = ("mon", "corr", "rob")

_UNJUDGED = ("constant", "no_data")


@dataclass(frozen=True)
class Recording:
    """A set of recordings.

    Attributes:
        title: what it is called.
        folder: where it lies in the folder of the recordings.
        window: W; the plant is too short for the paper's 5000.
        bins: B; the paper's 100.
    """

    title: str
    folder: str
    window: int
    bins: int = 100

    @property
    def parameters(self) -> Parameters:
        """The paper's m and tau for machines; a step in time above 1 ends a segment."""
        return Parameters.paper(bins=self.bins, window=self.window, max_gap=1)


RECORDINGS = {
    "plant": Recording("production plant", "production_plant", window=1000),
    "bearings": Recording("bearings", "femto_bearings", window=5000),
}


@dataclass(frozen=True)
class Certified:
    """What calibration says of a set of recordings.

    Attributes:
        verdicts: how many channels of machines have each verdict.
        floor: median of the floors.
        constant: asset and channel of those that did not move.
    """

    verdicts: dict[str, int]
    floor: float
    constant: frozenset[tuple[str, str]]


@dataclass(frozen=True)
class Row:
    """One method on one set of recordings.

    Attributes:
        recording, method: names.
        certified: what calibration says, whatever the method.
        metrics: the mean over channels of each metric; None where no channel has it.
        spread: their standard deviation over channels.
        signed: mean of the signed rank correlation over all series, and the share of series above 0.5.
        chance: mean of each metric for random series with the same windows; it does not depend on the
            method, and is told with the first one only.
        last_hi: median of the last indicators of the machines that failed.
        channels: how many were evaluated.
        series: of how many series.
        seconds: from the raw table to the health indicator, all channels.
    """

    recording: str
    method: str
    certified: Certified
    metrics: dict[str, float | None]
    spread: dict[str, float | None]
    signed: tuple[float, float]
    chance: dict[str, float | None]
    last_hi: float
    channels: int
    series: int
    seconds: float


def recordings(
    folder: Path, names: Sequence[str], methods: Sequence[str], quick: bool, results: Results, show: Show
) -> list[Row]:
    """Run what has no result yet, and return a row per set of recordings and method.

    Args:
        folder: of the recordings, with a folder for each set.
        names: sets, out of RECORDINGS.
        methods: names, out of METHODS.
        quick: train and fit for a moment only.
        results: where results are kept.
        show: told what is at work.

    Raises:
        SourceError: there is no such recording in the folder.
        UserError: see its subclasses.
    """
    check_libraries(methods)
    rows = []
    for name in names:
        recording = RECORDINGS[name]
        series = folder / recording.folder / "series.parquet"
        labels = series.with_name("labels.parquet")
        if not (series.is_file() and labels.is_file()):
            raise SourceError(
                f"There is no {series} with its labels.parquet; --data takes their folder."
            )
        show(f"{recording.title}: certificate")
        folder_of = f"recordings{'-quick' if quick else ''}"
        parameters = _settings_of(recording)
        certificate = results.get(
            f"{folder_of}/{name}-certificate",
            parameters,
            lambda: _certificate(recording, series),  # noqa: B023
        )
        certified = _certified(certificate)
        for method in methods:
            title = f"{recording.title}: {METHODS[method].title}"
            show(title)
            surrogates = SURROGATES if method == methods[0] else 0
            task = Task(0, quick, at_buckets=True)
            settings = {
                **parameters,
                "method": method,
                "seed": task.seed,
                "surrogates": surrogates,
                **METHODS[method].settings(task),
            }
            run = _runner(recording, series, labels, method, task, surrogates, certified, title, show)
            figures = results.get(f"{folder_of}/{name}-{method}", settings, run)
            rows.append(_row(name, method, certified, figures))
    return rows


def _settings_of(recording: Recording) -> dict[str, Any]:
    parameters = recording.parameters
    return {
        "experiment": "recordings",
        "recording": recording.folder,
        "calibration_fraction": CALIBRATION,
        "m": parameters.m,
        "tau": parameters.tau,
        "bins": parameters.bins,
        "window": parameters.window,
        "max_gap": parameters.max_gap,
        "constant": "left out",
    }


def _certificate(recording: Recording, series: Path) -> Figures:
    rows = support(
        Source(series, time="t"), recording.parameters, Calibration(fraction=CALIBRATION)
    ).to_pylist()
    columns = ("asset", "channel", "verdict", "floor")
    return {"channels": [{column: row[column] for column in columns} for row in rows]}


def _certified(figures: Figures) -> Certified:
    rows = figures["channels"]
    return Certified(
        verdicts=dict(Counter(row["verdict"] for row in rows).most_common()),
        floor=float(np.median([row["floor"] for row in rows if row["verdict"] not in _UNJUDGED])),
        constant=frozenset(
            (row["asset"], row["channel"]) for row in rows if row["verdict"] in _UNJUDGED
        ),
    )


def _runner(
    recording: Recording,
    series: Path,
    labels: Path,
    method: str,
    task: Task,
    surrogates: int,
    certified: Certified,
    title: str,
    show: Show,
) -> Callable[[], Figures]:
    def run() -> Figures:
        def on_epoch(epoch: int, loss: float) -> None:
            show(f"{title}: epoch {epoch}, loss {loss:.2e}")

        parameters = recording.parameters
        reporting_task = replace(task, on_epoch=on_epoch)
        calibration = Calibration(fraction=CALIBRATION)
        table, seconds = health(
            method, Source(series, time="t"), parameters, calibration, reporting_task
        )
        failed, constant = _failures(labels), certified.constant
        per_window = parameters.window // parameters.bucket_length
        channels = []
        for channel in sorted(set(table["channel"].to_pylist())):
            show(f"{title}: evaluating {channel}")
            channel_health = table.filter(pc.equal(table["channel"], channel))
            judged = {
                asset
                for asset in channel_health["asset"].to_pylist()
                if (asset, channel) not in constant
            }
            outcomes = [
                {"asset": asset, "channel": channel, "failed_at": end}
                for asset, end in failed.items()
                if asset in judged
            ]
            if not outcomes:
                continue
            metrics, channel_rows = summary(
                channel_health, pa.Table.from_pylist(outcomes), surrogates, per_window
            )
            shown = [row for row in channel_rows.to_pylist() if row["outcome"] == "failed"]
            if metrics["mon"] is None:
                continue  # it never moved
            channels.append(
                {
                    "channel": channel,
                    **{metric: metrics[metric] for metric in METRICS},
                    "signed": [row["mon_signed"] for row in shown if row["mon_signed"] is not None],
                    "last_hi": [row["last_hi"] for row in shown if row["last_hi"] is not None],
                    "chance": {
                        metric: _mean([row[f"{metric}_chance"] for row in shown]) for metric in CHANCE
                    },
                }
            )
        return {"channels": channels, "seconds": seconds}

    return run


def _failures(labels: Path) -> dict[str, int]:
    """Return when each asset that failed did, at the latest."""
    rows = parquet.read_table(labels).to_pylist()
    return {row["asset"]: row["end"] for row in rows if row["event"] == "end_of_life"}


def _row(recording: str, method: str, certified: Certified, figures: Figures) -> Row:
    channels: list[dict[str, Any]] = figures["channels"]
    signed = [value for channel in channels for value in channel["signed"]]
    columns = {metric: [channel[metric] for channel in channels] for metric in METRICS}
    return Row(
        recording=recording,
        method=method,
        certified=certified,
        metrics={metric: _mean(values) for metric, values in columns.items()},
        spread={metric: _spread(values) for metric, values in columns.items()},
        signed=(float(np.mean(signed)), float(np.mean(np.array(signed) > 0.5))),
        chance={metric: _mean([channel["chance"][metric] for channel in channels]) for metric in CHANCE},
        last_hi=float(np.median([value for channel in channels for value in channel["last_hi"]])),
        channels=len(channels),
        series=len(signed),
        seconds=figures["seconds"],
    )


def _mean(values: Sequence[float | None]) -> float | None:
    present = [value for value in values if value is not None]
    return float(np.mean(present)) if present else None


def _spread(values: Sequence[float | None]) -> float | None:
    present = [value for value in values if value is not None]
    return float(np.std(present, ddof=1)) if len(present) > 1 else None
