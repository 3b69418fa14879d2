"""``gam select``: which tau, m, B and W suit each channel, from its healthy part."""

import dataclasses
import shlex
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.checking.words import number_of
from gam_db.cli import automatic, options, page
from gam_db.cli.chosen import chosen, written
from gam_db.cli.config import DEFAULT_FILE, Settings, load
from gam_db.cli.course import Course
from gam_db.cli.job import Job, healthy_part, reading
from gam_db.cli.options import option
from gam_db.cli.render import WORDS, Notes, Page, Section, Title, show
from gam_db.columns import name_of
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.selection.search import Search
from gam_db.selection.select import Selection, alone
from gam_db.settings.parameters import AUTO
from gam_db.study import Study
from gam_db.study.automatic import Siblings


@options.taking(
    *(*options.READ, "everything", "as_json", "threads"),
    but=("tau", "stride", "score_from", "pool", "reference"),
)
def select(
    settings: Settings,
    search: Search,
    common: options.Common,
    write: Path | None = option("select.write"),
) -> None:
    """Choose delay, dimension, bins and window for every channel.

    It reads only the healthy part (--calibration-fraction 1 for all rows). --bins is the finest grid to
    try and --window the wanted window; --m applies where no rule finds a dimension. Each channel is
    studied alone: overrides and pools of gam.toml do not apply. --json prints all curves.
    """
    with reading(settings, common) as (session, whole, on_step):
        open_parameters = dataclasses.replace(whole.parameters, tau=AUTO, bins=AUTO, overrides=())
        alike = dataclasses.replace(whole.calibration, pool=None, reference=())
        study = Study(session, whole.guess.source, open_parameters, alike, on_step)
        study.forget()
    if whole.parameters.window == AUTO:
        window = study.method.parameters.window
        taken = dataclasses.replace(whole.parameters, window=window, stride=None)
        whole = dataclasses.replace(whole, parameters=taken)
    selection = chosen(settings, whole, search, common.threads)
    if write is not None:
        written(write, settings, whole, selection.choices.to_pylist())
    parameters, calibration = alone(whole.parameters, whole.calibration)
    job = dataclasses.replace(whole, parameters=parameters, calibration=calibration)
    figures = {
        "source": {"name": job.name, "guessed": job.guess.guessed},
        "settings_file": job.file,
        "search": search,
        "asked": {name: getattr(parameters, name) for name in _REQUESTED},
        **vars(selection),
        "scores": automatic.figures(study.siblings),
    }
    by_name = {name_of(row): of for of in study.siblings for row in of.channels}

    def sections() -> Iterator[Section]:
        yield from _sections(job, selection, common, by_name)
        if write is None:
            return
        file, named = printable(str(write)), f" --config {shlex.quote(str(write))}"
        yield f"written: {file}; read it, then: gam run{named * (write != Path(DEFAULT_FILE))}"
        if load(write).method()[1] != whole.calibration:
            yield WORDS["select"]["other_calibration"].format(file=file)

    show(Page(figures, sections(), failed=len(selection.failures) > 0), common)


_REQUESTED = ("m", "bins", "window", "target_floor")
_LAGS = (("minimum", "ami_minimum"), ("acf < 1/e", "acf_1e"), ("acf <= 0", "acf_zero"))


def _sections(
    job: Job,
    selection: Selection,
    common: options.Common,
    by_name: Mapping[tuple[str, str], Siblings],
) -> Iterator[Section]:
    choices: list[Row] = selection.choices.to_pylist()
    yield f"{printable(job.name)}: {number_of(len(choices), 'channel')}"
    yield job.columns_line()
    yield f"chosen from {healthy_part(job.calibration)}"
    curves = [_by_channel(table) for table in (selection.lags, selection.dimensions, selection.budget)]
    for choice in common.of(choices):
        key = (choice["asset"], choice["channel"])
        yield Title(" ".join(map(printable, key)))
        lines = list(_lines(choice, job.parameters.window, *(of[key] for of in curves)))
        if (of := by_name.get(key)) is not None:
            scores = f"by delay: {automatic.scores(of)}; {number_of(len(of.channels), 'sibling')}"
            lines.append(("score", f"{scores} take{'s' * (len(of.channels) == 1)} tau {of.tau}"))
        yield Notes(lines)
    for failure in selection.failures.to_pylist():
        yield ""
        name = f"{printable(failure['asset'])} {printable(failure['channel'])}"
        yield f"{name}: no choice, because of a fault of gam-db or its engine: {failure['reason']}"
    if len(choices) > options.SHOWN:
        yield ""
    yield from page.cut(choices, common.everything)


def _lines(
    choice: Row, window: int, lags: Sequence[Row], dimensions: Sequence[Row], budget: Sequence[Row]
) -> Iterator[tuple[str, str | Course]]:
    if choice["verdict"] in ("constant", "no_data"):
        words = {"constant": "did not move", "no_data": "no usable sample or no whole vector"}
        yield "", f"{choice['verdict']}: {words[choice['verdict']]} in {choice['samples']:,} samples"
        return
    tau = "-" if choice["tau"] is None else choice["tau"]
    others = ", ".join(f"{name} {choice[lag]}" for name, lag in _LAGS if choice[lag] is not None)
    yield "tau", f"{tau}: {WORDS['tau'][choice['tau_rule']]}" + (f" ({others})" if others else "")
    if len(lags) > 1:
        highest = max(row["ami"] for row in lags[1:])
        yield "AMI", Course(_scaled([row["ami"] for row in lags[1:]]))
        yield "", f"lags 1 to {lags[-1]['delay']}, up to {highest:.2f} nats"
        yield "acf", Course(_scaled([row["acf"] for row in lags[1:]]))
    dimension = WORDS["dimension"][choice["fnn_status"]].format(m=choice["m_fnn"])
    cao = WORDS["cao"][choice["cao_status"]].format(m=choice["m_cao"])
    yield "m", f"{dimension}; {cao}"
    if dimensions:
        shares = [row["false_share"] for row in dimensions]
        shown = " ".join("-" if share is None else f"{100 * share:.1f}" for share in shares)
        yield "", f"false neighbours, m = 1 to {len(shares)}: {shown} %"
    yield "window", _window(choice, window)
    if budget:
        finest = (row["finest_bins"] for row in budget)
        grids = " ".join("-" if bins is None else str(bins) for bins in finest)
        yield "bins", f"finest grid that this calibration fills, m = 1 to {len(budget)}: {grids}"
    yield "take", _together(choice)


def _window(choice: Row, window: int) -> str:
    taken = choice["recommended_window"]
    if taken is None:
        return WORDS["select"]["no_window"]
    wanted = window if choice["window_status"] != "short" else 5 * choice["cycle_length"]
    if taken < wanted:
        return WORDS["select"]["eighth"].format(taken=taken, wanted=wanted)
    if choice["window_status"] == "no_cycle":
        return f"{window}: as asked for; no cycle seen"
    cycle = choice["cycle_length"]
    held = f"{window} holds {window / cycle:.1f} cycles of {cycle} samples"
    if choice["window_status"] == "enough":
        return f"{window}: {held}"
    return f"{choice['recommended_window']}: {held}, which is short; take at least 5"


def _together(choice: Row) -> str:
    taken = {
        "--m": choice["recommended_m"],
        "--tau": 1 if choice["tau"] is None else choice["tau"],
        "--bins": choice["recommended_bins"],
        "--window": choice["recommended_window"],
    }
    line = " ".join(f"{option} {value}" for option, value in taken.items() if value is not None)
    if choice["verdict"] == "needs_data":
        needed = choice["vectors_needed"]
        more = "" if needed is None else f", about {needed:,} vectors more"
        return f"{line} (needs_data: no grid passes; calibrate longer{more})"
    return f"{line} (floor {choice['recommended_floor']:.3f})"


def _by_channel(table: pa.Table) -> Mapping[tuple[str, str], list[Row]]:
    rows: dict[tuple[str, str], list[Row]] = defaultdict(list)
    for row in table.to_pylist():
        rows[row["asset"], row["channel"]].append(row)
    return rows


def _scaled(curve: Sequence[float | None]) -> NDArray[np.float64]:
    """Return a curve between 0 and 1, whatever its range."""
    points: NDArray[np.float64] = np.array(curve, np.float64)
    finite = points[~np.isnan(points)]
    if not len(finite) or finite.max() == finite.min():
        return points * 0
    points = (points - finite.min()) / (finite.max() - finite.min())
    return points
