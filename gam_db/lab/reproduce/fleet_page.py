"""The pages of the fleet's tables and of the length of training."""

from collections.abc import Iterator

from gam_db.lab.estimators import DSE
from gam_db.lab.reproduce.bootstrap import METRICS
from gam_db.lab.reproduce.fleet import CALIBRATION
from gam_db.lab.reproduce.fleet_tables import SPREAD, FleetTable, Row
from gam_db.lab.reproduce.methods import method_named
from gam_db.lab.reproduce.paper import TABLE2, Printed, printed
from gam_db.lab.reproduce.training import Study

_TITLES = ("Mon", "Corr", "Rob", "Prog", "Disc", "Global")
_QUICK = "QUICK: few robots, short series and hardly any training; it shows that it works, nothing else."

OPEN = {
    1: "The fleet is simulated, with hours for the paper's months: other machines, other faults. The "
    "paper does not say how long networks are trained; here 20 epochs of batches of 256. scikit-learn "
    "is given 10,000 calibration vectors. VAE (latent) is the net of VAE (Rec), so its seconds leave "
    "training out.",
    3: "Contexts are as long as the window, those of the recurrent networks 200 samples; latent size "
    "20. The paper does not say which contexts are learnt, nor the sizes of CNN-AE and Transformer: "
    "here every tenth context of calibration, 20 epochs of batches of 32; convolutions of 16, 32 and 64 "
    "channels; 2 and 2 layers of 4 heads on words of 50 samples. VAE (latent)'s seconds leave training "
    "out.",
}


def fleet_table(table: FleetTable) -> Iterator[str]:
    """Yield the lines of the page of a table of the fleet."""
    plan = table.plan
    yield (
        f"simulated fleet, {table.seeds} seed{'s' * (table.seeds != 1)}: {table.joints[0]} joints that "
        f"failed, {table.joints[1]} of healthy robots, {plan.samples:,} samples each, the first "
        f"{CALIBRATION:.0%} taken as healthy; m = 3, tau = 1, B = 100, W = {plan.window}; mean ± "
        "standard deviation over the joints that failed"
    )
    if plan.quick:
        yield _QUICK
    yield ""
    yield f"{'':18}" + "".join(f"{title:>13}" for title in _TITLES) + f"{'seconds':>16}"
    paper = printed(table.number)
    for row in table.rows:
        yield _line(method_named(row.method).title, _ours(row), row.seconds)
        theirs = paper.get(row.method)
        if theirs is not None:
            yield _line("  paper", _theirs(theirs), (theirs.seconds, theirs.seconds_sd))
    yield ""
    if table.agreement is not None:
        count = sum(row.method in paper for row in table.rows)
        yield (
            f"Rank correlation of our order with the paper's: {table.agreement:.2f} over {count} "
            f"methods (random orders: 0 ± {(count - 1) ** -0.5:.2f})."
        )
    if table.number == 3:
        yield from _cost(table)
    yield ""
    yield from _paired(table)
    yield ""
    yield OPEN[table.number]


def training(study: Study) -> Iterator[str]:
    """Yield the lines of the page of the length of training."""
    yield "Langevin system, seed 0: networks by epochs, among the methods without networks"
    if study.quick:
        yield _QUICK
    yield ""
    yield f"{'epochs':>8}  {'':18}{'Mon':>9}{'Corr':>9}{'Rob':>9}{'Global':>9}{'place':>9}{'loss':>12}"
    for length in study.lengths:
        for name, figures in length.figures.items():
            numbers = "".join(f"{figures[key]:9.3f}" for key in ("mon", "corr", "rob", "global_score"))
            place = f"{length.order.index(name) + 1} of {len(length.order)}"
            title = method_named(name).title
            yield f"{length.epochs:>8}  {title:18}{numbers}{place:>9}{figures['losses'][-1]:12.2e}"
    names = list(study.lengths[0].figures)
    for name in names:
        theirs = TABLE2[name]
        numbers = "".join(
            f"{getattr(theirs, key):9.3f}" for key in ("mon", "corr", "rob", "global_score")
        )
        there = [method for method in TABLE2 if method in study.lengths[0].order]
        place = f"{there.index(name) + 1} of {len(there)}"
        yield f"{'paper':>8}  {method_named(name).title:18}{numbers}{place:>9}"
    yield ""
    yield "Rank correlation of the order of all these methods with the paper's, by epochs:"
    for length in study.lengths:
        order = ", ".join(method_named(name).title for name in length.order)
        yield f"{length.epochs:>8}  {length.agreement:+.2f}  {order}"


def _line(
    title: str,
    numbers: list[tuple[float | None, float | None]],
    seconds: tuple[float | None, float | None],
) -> str:
    cells = "".join(f"{_beside(value, spread, 2):>13}" for value, spread in numbers)
    return f"{title:18}{cells}{_beside(*seconds, 2):>16}"


def _ours(row: Row) -> list[tuple[float | None, float | None]]:
    return [(row.mean[metric], row.spread.get(metric)) for metric in METRICS]


def _theirs(row: Printed) -> list[tuple[float | None, float | None]]:
    fields = [getattr(row, "global_score" if metric == "global" else metric) for metric in METRICS]
    spreads = [getattr(row, f"{metric}_sd") if metric in SPREAD else None for metric in METRICS]
    return list(zip(fields, spreads, strict=True))


def _beside(value: float | None, spread: float | None, digits: int) -> str:
    if value is None:
        return "-"
    return f"{value:.{digits}f}" + ("" if spread is None else f" ±{spread:.{digits}f}")


def _cost(table: FleetTable) -> Iterator[str]:
    seconds = {row.method: row.seconds[0] for row in table.rows}
    if DSE not in seconds or len(seconds) == 1:
        return
    dearest = max(seconds, key=lambda name: seconds[name])
    yield (
        f"Cost: the dearest, {method_named(dearest).title}, takes {seconds[dearest] / seconds[DSE]:.0f} "
        f"times the seconds of DSE for each joint, and each joint takes a net of its own."
    )


def _paired(table: FleetTable) -> Iterator[str]:
    paired = table.paired
    yield (
        f"Paired bootstrap over the joints that failed, all {paired.resamples:,} resamples: share in "
        "which a method is best"
    )
    names = [row.method for row in table.rows]
    yield f"{'':18}" + "".join(f"{title:>9}" for title in _TITLES)
    for name in names:
        shares = [paired.best[metric].get(name) for metric in METRICS]
        cells = ("-" if share is None else f"{share:.1%}" for share in shares)
        yield f"{method_named(name).title:18}" + "".join(f"{cell:>9}" for cell in cells)
    first = paired.first
    others = [name for name in names if name != first]
    if not others:
        return
    yield ""
    yield f"{method_named(first).title} less each other method, 95 % interval of the resamples"
    yield f"{'':18}" + "".join(f"{title:>16}" for title in _TITLES)
    for name in others:
        intervals = [paired.differences[metric].get(name) for metric in METRICS]
        cells = (
            "-" if interval is None else f"{interval[0]:+.2f} to {interval[1]:+.2f}"
            for interval in intervals
        )
        yield f"{method_named(name).title:18}" + "".join(f"{cell:>16}" for cell in cells)
    if table.number == 1:
        yield "The paper: DSE has the highest Prog in 96 % of resamples."
