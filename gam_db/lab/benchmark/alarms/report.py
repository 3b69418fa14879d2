"""The figures as text, for people."""

from collections.abc import Iterator, Mapping
from typing import Any

_ESTIMATORS = {
    "dse": "Discrete Support Estimation",
    "forest": "Isolation Forest",
    "gmm": "Gaussian mixture",
}

Row = Mapping[str, Any]


def lines(figures: Row) -> Iterator[str]:
    """Yield the lines of a report on the figures of :mod:`~gam_db.lab.benchmark.alarms.measure`."""
    seeds = figures["seeds"]
    yield (
        f"Fleets {seeds[0]} to {seeds[-1]}, simulated, hours for months; {figures['samples']:,} samples,"
        f" W = {figures['window']:,}, B = {figures['bins']},\nstill_after 25, calibration "
        f"{figures['calibration']:.0%}; rates per 1,000 judgements, 95 % intervals by Poisson and by "
        "drawing\nthe channels again"
    )
    if figures["quick"]:
        yield "Quick: all paths run; nothing here says how good anything is."
    first = figures["promise"][0]
    yield ""
    yield f"Calm channels without a limit: {_withheld(first)}"
    yield ""
    yield "Promise: stated, and seen on calm channels"
    for row in figures["promise"]:
        yield f"  {_form_and_rate(row)}{_promised(row)}{_verdict(row, figures['quick'])}"
    yield ""
    yield "Wear: joints seen, and the median share of worn life that they had used"
    for row in figures["wear"]:
        yield f"  {_form_and_rate(row)}{of_wear(row)}"
    today = figures["today"]
    yield f"  {'today, twice the floor':33}{of_wear(today['wear'])}; seen {of_rate(today['rate'])}"
    yield ""
    control = figures["control"]
    yield (
        f"Control, a Bernoulli CUSUM with p0 = floor: stated {_thousand(control['stated'])}, "
        f"seen {of_rate(control)}: {_teeth(control)}"
    )
    if "rivals" in figures:
        yield ""
        yield "Other estimators under the same evidence, at equal realised false alarms"
        aimed = figures["rivals"][0]["rate"]["episodes"]
        for row in figures["rivals"]:
            more = ", the highest tried: opens more often" * (row["rate"]["episodes"] > aimed)
            at = "" if row["height"] is None else f" (height {row['height']:g}{more})"
            name = _ESTIMATORS[row["estimator"]]
            yield f"  {name}{at}: seen {of_rate(row['rate'])}; {of_wear(row['wear'])}"
        yield ""
        yield "Calm fleets that move, calibration of 40 % included"
        for row in figures["drift"]:
            yield f"  drift of {row['windows']:g} windows: {_moved(row)}"
        yield f"  two products in shifts: {_moved(figures['shifts'])}"


def _thousand(rate: float | None) -> str:
    return "-" if rate is None else f"{1000 * rate:.2f}"


def of_rate(row: Row) -> str:
    """Return a rate with its interval, per 1,000 judgements."""
    if row["lower"] is None:
        return "-"
    return (
        f"{_thousand(row['seen'])} [{_thousand(row['lower'])}, {_thousand(row['upper'])}] "
        f"({row['episodes']:,} in {row['judgements']:,})"
    )


def _promised(row: Row) -> str:
    if row["stated"] is None:
        return f"no rate can be stated; {_apart(row)}"
    bases = ", ".join(f"{basis} {its['channels']:,}" for basis, its in sorted(row["basis"].items()))
    ends = [
        _thousand(row[f"{drawn}{end}"]) for drawn in ("", "resampled_") for end in ("lower", "upper")
    ]
    return (
        f"stated {_thousand(row['stated'])}, seen {_thousand(row['seen'])} [{ends[0]}, {ends[1]}] "
        f"[{ends[2]}, {ends[3]}], {row['episodes']:,} in {row['judgements']:,}; {bases}{_apart(row)}"
    )


def _form_and_rate(row: Row) -> str:
    return f"{row['form']:20}{row['asked'].replace(' per 1000 judgements', ''):13}"


def _verdict(row: Row, is_quick: bool) -> str:
    """Return whether what is stated is kept; of rates that are an estimate nothing is promised."""
    if is_quick or row["kept"] is None:
        return ""
    if row["asked"] not in ("1 per 1000 judgements", "0.5 per 1000 judgements"):
        return "; an estimate"
    return "; kept" if row["kept"] else "; NOT KEPT"


def _apart(row: Row) -> str:
    apart = row["unstated"]
    if not apart["channels"]:
        return ""
    return f", none {apart['channels']:,}: {apart['episodes']:,} in {apart['judgements']:,}"


def _withheld(row: Row) -> str:
    if not row["withheld"]:
        return f"none of {row['calm']:,}"
    reasons = ", ".join(f"{reason} {count:,}" for reason, count in sorted(row["withheld"].items()))
    share = sum(row["withheld"].values()) / row["calm"]
    return f"{reasons} of {row['calm']:,} ({share:.1%})"


def of_wear(row: Row) -> str:
    """Return how many joints that wear were seen, and when."""
    kinds = ", ".join(f"{kind} {_of(its)}{_at(its)}" for kind, its in row["by_kind"].items())
    early = f", {row['early']:,} before 0.6" if row["seen"] else ""
    unseen = ", ".join(f"{why} {count:,}" for why, count in sorted(row["unseen"].items()))
    return f"{_of(row)}{_at(row)}{early}; {kinds}{f'; unseen: {unseen}' if unseen else ''}"


def _of(row: Row) -> str:
    return f"{row['seen']:,} of {row['joints']:,}"


def _at(row: Row) -> str:
    return "" if row["median"] is None else f" at {row['median']:.2f}"


def _teeth(control: Row) -> str:
    if control["seen"] is None:
        return "nothing to judge"
    times = control["seen"] / control["stated"]
    return f"{times:.1f} times what it states" + ("" if times >= 5 else "; THE BENCHMARK HAS NO TEETH")


def _moved(row: Row) -> str:
    ratio = row.get("order_ratio")
    ratio_text = "" if ratio is None else f"mean order ratio {ratio / 1000:.2f}; "
    return f"{ratio_text}{_promised(row)}; no limit: {_withheld(row)}"
