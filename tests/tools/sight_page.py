"""The picture of docs/sight.md: ``python tests/tools/sight_page.py > docs/figures/sight.svg``.

A stroke of 44 samples a cycle whose height changes, cut by two delays.
"""

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

import gam_db

#: Bins per axis, the delays of the two panels, samples, and how wide a panel is.
BINS, DELAYS, SAMPLES, SIDE = 16, (1, 11), 24_000, 320

Floats = NDArray[np.float64]


def signal() -> Floats:
    """Return the readings, (samples,), of one healthy machine."""
    time = np.arange(SAMPLES)
    height = 60 + 30 * np.sin(2 * np.pi * time / 907)
    noise = np.random.default_rng(1).normal(0, 1, SAMPLES)
    return height * np.sin(2 * np.pi * time / 44) + noise


def learnt(tau: int) -> dict[str, object]:
    """Return what the certificate says of the first half under a delay."""
    readings = pa.table({"time": np.arange(SAMPLES), "value": signal()})
    method = gam_db.Parameters(m=3, tau=tau, bins=BINS, window=500), gam_db.Calibration(fraction=0.5)
    (row,) = gam_db.support(readings, *method).to_pylist()
    return dict(row)


def panel(tau: int, left: int) -> list[str]:
    """Return one panel: healthy cells by two coordinates, and vectors of two faults."""
    healthy = signal()[: SAMPLES // 2]
    lo, width = healthy.min(), np.ptp(healthy)

    def squares(values: Floats, kind: str) -> list[str]:
        bins = np.clip((values - lo) / width * BINS, 0, BINS - 1).astype(int)
        cells = sorted(set(zip(bins[tau:].tolist(), bins[:-tau].tolist(), strict=True)))
        side = SIDE / BINS
        return [
            f'<rect class="{kind}" x="{left + a * side:.1f}" y="{60 + (BINS - 1 - b) * side:.1f}" '
            f'width="{side - 1:.1f}" height="{side - 1:.1f}"/>'
            for a, b in cells
        ]

    def dots(values: Floats, kind: str) -> list[str]:
        x, y = ((part - lo) / width * SIDE for part in (values[tau:], values[:-tau]))
        return [
            f'<circle class="{kind}" cx="{left + a:.1f}" cy="{60 + SIDE - b:.1f}" r="1.6"/>'
            for a, b in zip(x.tolist(), y.tolist(), strict=True)
        ]

    middle = float(np.median(healthy))
    half = middle + 0.5 * (healthy - middle)
    still = [
        f'<circle class="frozen" cx="{left + a:.1f}" cy="{60 + SIDE - a:.1f}" r="3"/>'
        for a in ((healthy[::400] - lo) / width * SIDE).tolist()
    ]
    row = learnt(tau)
    unseen = row["would_not_see"] or "nothing of these"
    return [
        f'<text x="{left}" y="24" class="title">delay {tau}: sees shifts of {row["sees"]} %</text>',
        f'<text x="{left}" y="44">would not see: {unseen}</text>',
        f'<rect class="frame" x="{left}" y="60" width="{SIDE}" height="{SIDE}"/>',
        *squares(healthy, "healthy"),
        *dots(half[600:750], "half"),
        *still,
        f'<text x="{left}" y="{SIDE + 78}">x(t) →, x(t - {tau}) ↑</text>',
    ]


def picture() -> str:
    """Return the picture as SVG."""
    parts = [line for place, tau in enumerate(DELAYS) for line in panel(tau, 10 + place * (SIDE + 40))]
    wide, high = 2 * SIDE + 60, SIDE + 110
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" role="img" '
            'aria-label="Healthy cells of one signal under two delays, and vectors of two faults">',
            "<style>text{font:13px sans-serif;fill:#333}.title{font-weight:bold}"
            ".frame{fill:none;stroke:#bbb}.healthy{fill:#c9dbe8}.half{fill:#d17a00}.frozen{fill:#b3261e}</style>",
            f'<rect width="{wide}" height="{high}" fill="#fff"/>',
            *parts,
            f'<text x="10" y="{SIDE + 100}">blue: cells of health; red: a frozen sensor; orange: '
            "half a stroke</text>",
            "</svg>",
        ]
    )


if __name__ == "__main__":
    print(picture())
