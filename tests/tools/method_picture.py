"""Draw the picture of the README: ``python tests/tools/method_picture.py docs/figures/method.svg``.

A signal of 20 samples a cycle that grows a second movement, its delay vectors (m = 2) on a grid of 16
bins, and its health indicator, which gam_db computes.
"""

import sys
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

import gam_db
from gam_db.lab.reproduce.svg import BLACK, DARK, GREY, Drawing, Plot

#: Samples, delay, bins per axis, vectors of the window, share of healthy samples, and when wear begins.
SAMPLES, TAU, BINS, WINDOW, HEALTHY, WEAR = 6_000, 5, 16, 200, 0.4, 3_600
BLUE, RED = "#c9dbe8", "#b3261e"
#: Of the picture: the lowest and highest reading that it shows, and its healthy and its later samples.
LOWEST, HIGHEST = -1.7, 1.7
SHOWN = ((1_000, 1_060), (5_900, 5_960))

Floats = NDArray[np.float64]


def signal() -> Floats:
    """Return the readings, (samples,)."""
    time = np.arange(SAMPLES)
    noise = np.random.default_rng(3).normal(0, 0.03, SAMPLES)
    wear = np.clip((time - WEAR) / (SAMPLES - WEAR), 0, 1)
    readings: Floats = (
        np.sin(2 * np.pi * time / 20) + 0.6 * wear * np.sin(2 * np.pi * time / 7.3) + noise
    )
    return readings


def draw(path: Path) -> None:
    """Write the picture."""
    readings = signal()
    drawing = Drawing(
        960, 300, "How the method works: a signal, its delay vectors in cells, the indicator"
    )
    _signal(drawing, readings)
    _cells(drawing, readings)
    _indicator(drawing, readings)
    drawing.write(path)


def _signal(drawing: Drawing, readings: Floats) -> None:
    plot = Plot(drawing, (50, 40), (240, 200), (0, 130), (LOWEST, HIGHEST))
    plot.frame([], [-1, 0, 1], "time", title="1. A signal: healthy, and worn")
    for (begin, end), left, colour in zip(SHOWN, (0, 70), (BLACK, RED), strict=True):
        plot.line(((left + step, readings[begin + step]) for step in range(end - begin)), colour)


def _cells(drawing: Drawing, readings: Floats) -> None:
    plot = Plot(drawing, (360, 40), (240, 200), (LOWEST, HIGHEST), (LOWEST, HIGHEST))
    healthy = readings[: int(SAMPLES * HEALTHY)]
    low, width = healthy.min(), np.ptp(healthy)
    step = width / BINS
    bins = np.clip((healthy - low) / step, 0, BINS - 1).astype(int)
    for newest, delayed in sorted(set(zip(bins[TAU:].tolist(), bins[:-TAU].tolist(), strict=True))):
        left, top = plot.at(low + newest * step, low + (delayed + 1) * step)
        right, bottom = plot.at(low + (newest + 1) * step, low + delayed * step)
        drawing.box(left, top, right - left, bottom - top, BLUE, "#ffffff")
    (begin, end), colours = SHOWN[1], {True: RED, False: BLACK}
    cells = set(zip(bins[TAU:].tolist(), bins[:-TAU].tolist(), strict=True))
    for newest, delayed in zip(readings[begin:end], readings[begin - TAU : end - TAU], strict=True):
        cell = int((newest - low) // step), int((delayed - low) // step)
        drawing.dots([plot.at(newest, delayed)], colours[cell not in cells], 4)
    plot.frame([], [], "x(t)", f"x(t - {TAU})", "2. Healthy cells, and later vectors")


def _indicator(drawing: Drawing, readings: Floats) -> None:
    table = pa.table({"time": np.arange(SAMPLES), "value": readings})
    parameters = gam_db.Parameters(m=2, tau=TAU, bins=BINS, window=WINDOW, range="min_max")
    health = gam_db.health_indicator(table, parameters, gam_db.Calibration(fraction=HEALTHY))
    rows = sorted(zip(health["time"].to_pylist(), health["hi"].to_pylist(), strict=True))
    points = [(time, indicator) for time, indicator in rows if indicator is not None][::10]
    plot = Plot(drawing, (670, 40), (260, 200), (SAMPLES * HEALTHY, SAMPLES), (0, 1))
    plot.line([(WEAR, 0), (WEAR, 1)], GREY, dash="2 2")
    plot.line(points, RED, 1.6)
    plot.frame(
        [3_000, 4_000, 5_000, 6_000],
        [0, 0.5, 1],
        "time",
        title="3. The indicator: share of novel vectors",
    )
    drawing.text(*plot.at(WEAR + 60, 0.93), "wear begins", fill=DARK, size=11)


if __name__ == "__main__":
    draw(Path(sys.argv[1]))
