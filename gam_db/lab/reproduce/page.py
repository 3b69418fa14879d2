"""The pages that ``gam reproduce`` prints: our numbers beside the paper's, and how to read them."""

from collections.abc import Iterator, Sequence

from gam_db.lab.reproduce import sensitivity
from gam_db.lab.reproduce.fleet import ROBOTS
from gam_db.lab.reproduce.methods import METHODS
from gam_db.lab.reproduce.paper import TABLE2
from gam_db.lab.reproduce.recordings import CHANCE, METRICS, RECORDINGS
from gam_db.lab.reproduce.recordings import Row as RecordingRow
from gam_db.lab.reproduce.table2 import NUMBERS, Table

_SHOWN = ("Mon", "Corr", "Rob", "Prog", "Global")

CIRCULAR = (
    "The paper does not give the numbers of the Langevin system. Those used here were chosen with "
    "DSE's row in view, so DSE's agreement with its row is no evidence; only the order of the other "
    "methods can be."
)
OPEN = (
    "The paper does not say how long networks are trained, in which batches, with which activation, or "
    "how vectors are scaled; here: 20 epochs of batches of 256, ReLU, ranges of calibration. It was set "
    "once and not changed after a result was seen. scikit-learn is given 10,000 calibration vectors."
)
_TRAINING = "the length of training is not given; the paper's few seconds suggest a short one."
CAUSES = {
    "gmm": "its score has no bound and grows faster than the wear, which Corr punishes.",
    "forest": "where the wells lie and how far they drift is not given, and it decides.",
    "ocsvm": "on which scale, and on how many vectors, the paper's was fitted is not given.",
    "centroid": "how far the mean distance to one centre moves depends on where the wells lie and "
    "whither they drift, which is not given.",
    "ae": "the length of training is not given.",
    "vae_rec": "the weight of the divergence is not given; with weight 1 on values from 0 to 1 the "
    "latent units collapse, and the reconstruction is the mean vector whatever the vector, as Centroid.",
    "vae_latent": "the latent units collapse (as in VAE (Rec)): the divergence is about a hundred "
    "thousandth everywhere, and its changes mean little.",
    "mlp": _TRAINING,
    "lstm": _TRAINING,
    "lstm_ae": _TRAINING,
}
"""Of a method that comes out elsewhere than in the paper: the likely cause."""

_SHORT_DELAY = 5  # up to which the paper sees Global rise with m

_FAR = 3
"""Places from which on a method is said to come out elsewhere."""
_FAR_GLOBAL = 0.05
"""Difference of Global from which on it is."""


def table2(table: Table) -> Iterator[str]:
    """Yield the lines of the page of the Langevin system."""
    yield (
        f"Langevin system, {table.samples:,} steps, m = 3, tau = 58, B = 100, W = 5000; "
        f"{table.seeds} seed{'s' * (table.seeds != 1)}: mean ± standard deviation"
    )
    if table.quick:
        yield "QUICK: a short series and hardly any training; it shows that it works, and nothing else."
    yield ""
    titles = "".join(f"{title:>9}{'':6}" for title in ("Mon", "Corr", "Rob", "Global"))
    yield f"{'':18}{titles}{'seconds':>10}"
    for row in table.rows:
        ours = "".join(_beside(row.mean[name], row.spread[name]) for name in NUMBERS)
        yield f"{METHODS[row.method].title:18}{ours}{row.seconds:10.1f}"
        theirs = "".join(_beside(getattr(TABLE2[row.method], name)) for name in NUMBERS)
        yield f"{'  paper':18}{theirs}".rstrip()
    yield f"{'chance':18}{''.join(_beside(table.chance[name]) for name in CHANCE)}".rstrip()
    yield ""
    yield (
        f"chance: random scores under the same window, {table.windows} windows that do not overlap. "
        "seconds: from the raw table to the indicator, median, on this machine as busy as it was."
    )
    yield from _agreement(table)
    yield ""
    yield CIRCULAR
    yield OPEN


def recordings(rows: Sequence[RecordingRow]) -> Iterator[str]:
    """Yield the lines of the page of the recordings."""
    for name, recording in RECORDINGS.items():
        recording_rows = [row for row in rows if row.recording == name]
        if not recording_rows:
            continue
        first = recording_rows[0]
        yield (
            f"{recording.title}: m = 3, tau = 1, B = {recording.bins}, W = {recording.window}, the "
            f"first 20 % taken as healthy; mean ± standard deviation over {first.channels} channels "
            f"({first.series} series of machines that failed)"
        )
        verdicts = ", ".join(f"{count} {verdict}" for verdict, count in first.certified.verdicts.items())
        yield f"certificate: {verdicts}; floor {first.certified.floor:.3f} in the median"
        yield ""
        titles = "".join(f"{title:>9}{'':6}" for title in _SHOWN)
        yield f"{'':18}{titles}{'rising':>9}{'seconds':>10}"
        for row in recording_rows:
            numbers = "".join(_beside(row.metrics[metric], row.spread[metric], 2) for metric in METRICS)
            yield f"{METHODS[row.method].title:18}{numbers}{row.signed[1]:>9.0%}{row.seconds:10.1f}"
        chance = "".join(_beside(first.chance.get(metric)) for metric in METRICS)
        yield f"{'chance':18}{chance.rstrip()}"
        for row in recording_rows:
            if row.method == "dse":
                yield (
                    f"DSE ends at {row.last_hi:.2f} in the median; near 1 it is saturated, and Prog is "
                    "high for that alone."
                )
        yield ""
    yield (
        "chance: random scores under the same windows. rising: share of the series whose signed rank "
        "correlation with time is above 0.5; Mon and Corr are sizes, and a falling indicator has them, "
        "too. Prog compares the last value over the machines that failed; there is no healthy control, "
        "so no Disc, and Global is the mean of the four."
    )


def sensitivity_page(on: str, cells: Sequence[sensitivity.Cell], quick: bool) -> Iterator[str]:
    """Yield the lines of the page of m and tau."""
    of_fleet = on == sensitivity.FLEET
    yield (
        f"simulated fleet, {ROBOTS} robots, 5 of them to failure" if of_fleet else "Langevin system"
    ) + "; DSE, B = 100"
    if quick:
        yield "QUICK: short series and windows; it shows that it works, and nothing else."
    views = {"global_score": "Global", "floor": "floor of the certificate", "at_end": "last HI, failed"}
    if of_fleet:
        views |= {"healthy": "healthy HI later seen", "prog": "Prog", "disc": "Disc", "mon": "Mon"}
    by_place = {(cell.m, cell.tau): cell for cell in cells}
    for number, title in views.items():
        yield ""
        yield f"{title:26}" + "".join(f"{f'tau = {tau}':>10}" for tau in sensitivity.DELAYS)
        for m in sensitivity.DIMENSIONS:
            values = [getattr(by_place[m, tau], number) for tau in sensitivity.DELAYS]
            shown = "".join(f"{'-' if value is None else format(value, '.3f'):>10}" for value in values)
            yield f"{f'  m = {m}':26}{shown}"
    yield ""
    yield "As m grows from the smallest to the largest:"
    yield (
        f"{'  tau':>6}{'Global':>10}{'rank corr.':>12}{'paper':>10}{'floor':>18}{'passes to':>12}"
        f"{'best at':>10}"
    )
    for trend in sensitivity.trends(cells):
        same = "the same" if (trend.change > 0) == (trend.tau <= _SHORT_DELAY) else "not so"
        floors = f"{trend.floors[0]:.3f} to {trend.floors[1]:.3f}"
        passed = "-" if trend.passed is None else f"m = {trend.passed}"
        yield (
            f"{trend.tau:>6}{trend.change:>+10.3f}{trend.by_rank:>+12.2f}{same:>10}{floors:>18}"
            f"{passed:>12}{f'm = {trend.best}':>10}"
        )
    yield (
        "paper: on its industrial fleet Global rises for tau <= 5 and falls for tau > 5. passes to: the "
        "largest m whose floor is within the certificate's target. best at: the m of the best Global."
    )
    changes = [
        f"{title} by {change:+.3f}"
        for title, number in (("Prog", "prog"), ("Disc", "disc"), ("Mon", "mon"))
        if (change := sensitivity.change(cells, number)) is not None
    ]
    if of_fleet:
        yield (
            f"In the mean over the delays, from the smallest m to the largest: {', '.join(changes)}. A "
            "sparse support adds to Prog and takes from Disc; which decides depends on the fleet."
        )
    foretold = sensitivity.foretold(cells)
    if foretold is not None:
        yield (
            f"Over the {len(cells)} settings the floor, known from calibration alone, and the healthy "
            f"HI later seen have a rank correlation of {foretold:.2f}."
        )


def _agreement(table: Table) -> Iterator[str]:
    if table.agreement is None:
        yield "With fewer than three methods there is no order to compare."
        return
    count = len(table.rows)
    yield (
        f"Rank correlation of our order with the paper's: {table.agreement:.2f} over {count} methods "
        f"(random orders: 0 ± {(count - 1) ** -0.5:.2f})."
    )
    paper = [name for name in TABLE2 if name in {row.method for row in table.rows}]
    elsewhere = []
    for place, row in enumerate(table.rows, 1):
        ours, printed = row.mean["global_score"], TABLE2[row.method].global_score
        printed_place = paper.index(row.method) + 1
        if abs(place - printed_place) >= _FAR or abs(ours - printed) >= _FAR_GLOBAL:
            cause = CAUSES.get(row.method, "its row was in view when the system was chosen.")
            title = METHODS[row.method].title
            places = f"place {place}, Global {ours:.3f}; paper {printed_place}, {printed:.3f}"
            elsewhere.append(f"  {title}: {places}: {cause}")
    if not elsewhere:
        yield f"No method is {_FAR} places or {_FAR_GLOBAL} of Global from where the paper has it."
        return
    yield f"Not as in the paper ({_FAR} places, or {_FAR_GLOBAL} of Global), with the likely cause:"
    yield from elsewhere


def _beside(value: float | None, spread: float | None = None, digits: int = 3) -> str:
    """Return a number and its spread in a column of 15 places."""
    if value is None:
        return f"{'-':>9}{'':6}"
    return f"{value:9.3f}" + ("" if spread is None else f" ±{spread:.{digits}f}").ljust(6)
