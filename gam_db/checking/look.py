"""One look at a source: the figures of every channel, by the formulas of ``sql/check``."""

import dataclasses
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.checking.programs import Candidate, candidates, program_rows
from gam_db.clock import TimeKind
from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.base import Engine
from gam_db.engines.session import Session
from gam_db.method import Method
from gam_db.method.adding import add, add_stacked
from gam_db.reading.ahead import Clock
from gam_db.reading.undated import Undated
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource, TimeNode, parsed_condition, read_from
from gam_db.study import Study
from gam_db.study.automatic import window_of
from gam_db.study.running import Listener

SUMMARY = "check_summary"

PAUSE = 5
"""A step in time longer than this many typical ones is a pause."""

SCALES = (1, 4, 16, 64, 256)
"""Samples of a block, on each scale on which a cycle is looked for."""
LONGEST_LAG = 80
"""Blocks; a cycle of up to ``LONGEST_LAG * SCALES[-1]`` samples is seen."""
_SHORTEST_LAG = 4
_SHORTEST_LAG_OF_BLOCKS = 20
"""Below it the scale before is finer."""
_BLOCKS = 2 * LONGEST_LAG
LONGEST_SAMPLE = 4 * _BLOCKS * SCALES[-1]
"""Samples of a channel in which a cycle is looked for, from its first on."""
VALUES_LOOKED_AT = LONGEST_SAMPLE // 8
"""Samples of a channel in which distinct values are counted."""

LEAST_STILL = 25
"""Equal samples in a row at least from which on a signal is proposed to count as still."""
STILL_LASTING = 5_000_000
"""Microseconds that these last at least."""

_SMALL = frozenset(
    (
        *("step_counts", "pauses", "movements", "longest_stills"),
        *("granules", "quarters", "quanta", "block_sums", "correlations", "cycles", "stood"),
    )
)


def add_look(steps: Pipeline, method: Method, instant_of: TimeNode) -> None:
    """Add the steps of the look, of which SUMMARY is the last, to those of a method."""
    add(steps, "check/ordered_samples")
    add(steps, "check/step_counts", {"longest_sample": LONGEST_SAMPLE})
    add(steps, "check/step_ranks")
    add(steps, "check/typical_steps")
    add(steps, "check/pauses", {"pause": PAUSE})
    add(steps, "check/movements")
    add(steps, "check/longest_stills")
    stands: dict[str, template.Slot] = {
        "still_after": _by_setting([setting.still_after for setting in method.settings]),
        "max_gap": _by_setting(method.gaps),
        "least": LEAST_STILL,
        "lasting": 0 if method.kind.is_counter else STILL_LASTING,
    }
    add(steps, "check/stood", stands)
    add(steps, "check/head_samples", {"longest_sample": LONGEST_SAMPLE})
    place = exp.column("place", table="early")
    reached = ((place < scale * _BLOCKS, scale) for scale in SCALES[:-1])
    add(steps, "check/granules", {"size": template.case(reached, SCALES[-1])})
    add(steps, "check/quarters", {"looked_at": VALUES_LOOKED_AT // 4})
    add(steps, "check/distinct_values")
    add(steps, "check/quanta")
    shortest = (_SHORTEST_LAG, *[_SHORTEST_LAG_OF_BLOCKS] * (len(SCALES) - 1))
    rungs = [{"scale": scale, "shortest": lag} for scale, lag in zip(SCALES, shortest, strict=True)]
    add_stacked(steps, "check/scales", rungs)
    add(steps, "check/block_sums")
    add(steps, "check/lag_sums", {"longest_lag": LONGEST_LAG})
    add(steps, "check/correlations")
    add(steps, "check/peaks")
    add(steps, "check/cycles")
    edges = {name: instant_of(exp.column(name, table="figures")) for name in ("first_time", "last_time")}
    add(steps, "check/check_summary", edges)
    steps.small |= _SMALL


def _by_setting(figures: Sequence[int | None]) -> exp.Expr:
    """Return the figure of a channel by the number of its settings."""
    number = exp.column("settings_no", table="channel_row")
    others = enumerate(figures[1:], start=1)
    return template.case(((number.eq(place), figure) for place, figure in others), figures[0])


_NUMBER = re.compile(
    r"\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*|\s*[+-]?(nan|inf(inity)?)\s*", re.ASCII | re.I
)

IRREGULAR = 3
"""The step that 95 % are no longer than, in steps that 5 % are no longer than, above which sampling is
irregular."""
REGULAR_WITHIN = 1.5
"""Steps that differ by no more than this factor are about the same."""
_STILL_ON_CHANGE = 0.01

#: A row of the summary by name; times and steps are integers: counter steps, or microseconds.
Row = dict[str, Any]


@dataclass(frozen=True)
class Look:
    """The results of the checks."""

    source: AnySource  # with its channels named
    method: Method  # the parameters and the calibration it was looked at with
    table: pa.Table  # a row per (asset, channel) pair, as :func:`check` returns it
    channels: tuple[Row, ...]  # the rows of those that have a name and a time, in order
    nameless: dict[str, int]  # rows of the source without asset, channel and time, by these words
    exact: tuple[str, ...]  # columns of readings that are integers or decimals, not doubles
    number_texts: tuple[str, ...]  # text columns that are not read and hold numbers
    undated: Undated | None  # rows that tell no time, or two; None where there can be none
    engine: Engine  # that was asked
    clock: Clock  # of the database, as it was read
    ahead: tuple[Row, ...]  # of :func:`gam_db.reading.ahead.rows_ahead`
    programs: tuple[Row, ...]  # of each channel, where a column names them
    candidates: tuple[Candidate, ...]  # columns that look as if they did

    @property
    def kind(self) -> TimeKind:
        """The kind of time of the source."""
        return self.method.kind

    def setting(self, row: Row) -> Parameters:
        """Return the parameters of a channel."""
        return self.method.settings[row["settings_no"]]

    def gap(self, row: Row) -> int | None:
        """Return max_gap of a channel as an integer; None for no limit."""
        return self.method.gaps[row["settings_no"]]


def look_at(
    session: Session,
    source: AnySource,
    parameters: Parameters,
    calibration: Calibration,
    on_step: Listener = lambda _: None,
) -> Look:
    """Look at a source; arguments and errors as in :class:`~gam_db.study.Study`."""
    arguments = session, source, parameters.finest(), calibration
    study = Study(*arguments, on_step, strict=False)
    add_look(study.steps, study.method, study.instant_of)
    summary = study.table(SUMMARY)
    table = summary.drop_columns(["settings_no"])
    rows = summary.drop_columns(["first_time", "last_time"]).to_pylist()
    roles = ("asset", "channel")
    nameless = {role: sum(row["readings"] for row in rows if row[role] is None) for role in roles}
    nameless["time"] = sum(row["without_time"] for row in rows)
    channels = tuple(row for row in rows if row["samples"] is not None)
    exact = exact_columns(study.session, study.source, study.columns)
    undated = study.undated() if nameless["time"] or source.source_time_zone is not None else None
    invalid = study.invalid()
    for row in channels if study.source.valid_when is not None else ():
        row["invalid"] = invalid.get(name_of(row), 0)
    programs = program_rows(study)
    others = _number_texts(study), undated, session.engine, study.clock, tuple(study.ahead)
    method = study.method
    if parameters.is_open:
        moving = [row["calibration_samples"] for row in channels if row["rises"] or row["falls"]]
        closed = parameters.finest(window_of(moving))
        method = dataclasses.replace(method, parameters=closed, requested=parameters)
    columns = candidates(study, min(setting.window for setting in method.settings))
    return Look(study.source, method, table, channels, nameless, exact, *others, programs, columns)


def exact_columns(session: Session, source: AnySource, columns: Mapping[str, str]) -> tuple[str, ...]:
    """Return the columns of readings that are integers or decimals, not doubles, of name -> type."""
    types = session.engine.types
    return tuple(
        name
        for name in source.value_columns
        if types.is_numeric(columns.get(name, "")) and not types.is_binary_float(columns[name])
    )


def is_irregular(row: Row) -> bool:
    """Tell whether a channel is not sampled regularly, bursts with pauses between them left aside."""
    if row["typical_step"] is None or row["long_step"] <= IRREGULAR * row["short_step"]:
        return False
    in_bursts = row["long_step"] > row["longest_step"]
    return not (in_bursts and row["longest_step"] <= REGULAR_WITHIN * row["short_step"])


def is_on_change(row: Row) -> bool:
    """Tell whether a channel seems to be written only when its value changes (a deadband)."""
    compared = row["rises"] + row["falls"] + row["stills"]
    return is_irregular(row) and compared > 0 and row["stills"] <= _STILL_ON_CHANGE * compared


def _number_texts(study: Study) -> tuple[str, ...]:
    """Return the text columns that nothing reads, although all their texts are numbers."""
    source, session = study.source, study.session
    read = set(source.columns.values())
    numeric = []
    for column, type_name in study.columns.items():
        if column in read or not session.engine.types.is_text(type_name):
            continue
        query = template.fill(
            "check/number_texts",
            {"words": template.column(column), "condition": parsed_condition(source.where)},
        )
        read_from(study.relation, query)
        words = [row["word"] for row in session.rows(query)]
        if words and all(map(_NUMBER.fullmatch, words)):
            numeric.append(column)
    return tuple(numeric)
