"""The method: which steps there are, in which order, and what their slots hold.

This module owns the way from readings to the health indicator and its certificate (method, sections
2 to 5) as a :class:`~gam_db.pipeline.Pipeline`. It makes trees; it runs nothing and knows no engine.

Steps of channels with the same parameters form a *set*; where there are several sets, the steps of
each carry its number, and the rows of all sets are put under one another before the last steps.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sqlglot import exp

from gam_db import template
from gam_db.calibration import Calibration, Rule, resolve
from gam_db.clock import LONG_AGO, TimeKind, length
from gam_db.parameters import Parameters
from gam_db.pipeline import Pipeline, filled, union_of
from gam_db.source import TimeNode

#: Steps that are small: a row per channel, interval, bucket or cell. They may be kept on the way.
SMALL = frozenset(
    (
        *("names", "rules", "declared", "channels", "timeline", "recounted", "series"),
        *("limits", "calibration", "calibrated"),
    )
)
SMALL_OF_SET = frozenset(
    (
        *("breaks", "bounds", "support", "visits", "block_sizes", "cells", "blocks", "learning"),
        *("levels", "ladder", "spread", "finest", "outlook", "missing_vectors"),
        *("run_up", "kept", "buckets"),
    )
)

#: Steps whose sets are put under one another.
_JOINED_HEALTH = ("window_counts",)
_JOINED_BUCKETS = ("bucket_counts", "novel_cells")
_JOINED_CERTIFICATE = (
    "bounds",
    "cells",
    "blocks",
    "learning",
    "spread",
    "finest",
    "outlook",
    "missing_vectors",
)


@dataclass(frozen=True)
class Method:
    """What the user asked for, resolved: the input of every pipeline.

    Attributes:
        parameters: with their overrides.
        calibration: with its overrides and pools.
        kind: how the source tells time.
        instant_of: turns integer time into what the source has, for the last steps.
        settings: the distinct sets of parameters; number 0 is the general one.
        rules: calibration in integers; number 0 is the general one.
        gaps: max_gap of each set, in steps of the clock.

    Raises:
        CalibrationError, ParameterError: calibration or max_gap does not fit the kind of time.
    """

    parameters: Parameters
    calibration: Calibration
    kind: TimeKind
    instant_of: TimeNode
    settings: tuple[Parameters, ...] = field(init=False)
    rules: tuple[Rule, ...] = field(init=False)
    gaps: tuple[int | None, ...] = field(init=False)

    def __post_init__(self) -> None:
        distinct = tuple(dict.fromkeys(self.parameters.variants()))
        object.__setattr__(self, "settings", distinct)
        object.__setattr__(self, "rules", tuple(resolve(self.calibration, self.kind)))
        object.__setattr__(
            self,
            "gaps",
            tuple(
                None if setting.max_gap is None else length(setting.max_gap, self.kind, "max_gap")
                for setting in distinct
            ),
        )

    def named(self, step: str, number: int) -> str:
        """Return what a step of one set is called."""
        return step if len(self.settings) == 1 else f"{step}_{number}"

    def small(self) -> set[str]:
        """Return the names of the steps that may be kept as tables."""
        numbers = range(len(self.settings))
        return set(SMALL) | {self.named(step, n) for step in SMALL_OF_SET for n in numbers}


def pipeline(method: Method, readings: exp.Query) -> Pipeline:
    """Return all steps of the method over the given readings.

    The last steps are *health_indicator* (a row per scored vector), *bucket_health* (a row per full
    bucket), *novel_cells*, *support_summary* (a row per channel) and *certificate* (a row per block).
    """
    steps = Pipeline(small=frozenset(method.small()))
    steps.add("readings", readings, template.load("source/readings").comment)
    add_source(steps, method)
    numbers = range(len(method.settings))
    for number in numbers:
        add_calibration(steps, method, number)
        add_scoring(steps, method, number)
        add_buckets(steps, method, number)
        add_certificate(steps, method, number)
    join_sets(steps, method, (*_JOINED_HEALTH, *_JOINED_BUCKETS, *_JOINED_CERTIFICATE))
    add_results(steps, method)
    return steps


def add_source(steps: Pipeline, method: Method) -> None:
    """Add what speaks of whole channels: names, samples, calibration intervals (sections 2 and 4)."""
    _add(steps, "source/names")
    rules = [
        filled(
            "calibration/rules",
            {
                "calibration_no": number,
                "fraction": rule.fraction,
                "duration": rule.duration,
                "declared_end": rule.declared_end,
                "score_from": rule.score_from,
            },
        )
        for number, rule in enumerate(method.rules)
    ]
    _add_stacked(steps, "rules", "calibration/rules", rules)
    pieces = [
        filled(
            "calibration/declared",
            {"calibration_no": number, "time_from": start, "time_to": end},
        )
        for number, rule in enumerate(method.rules)
        for start, end in rule.allowed
    ]
    if pieces:
        _add_stacked(steps, "declared", "calibration/declared", pieces)
    else:
        _add(steps, "calibration/undeclared", name="declared")
    _add(
        steps,
        "source/channels",
        {
            "settings_no": _chosen(
                [
                    (_pattern("asset", override.asset), _pattern("channel", override.channel), n)
                    for override, n in zip(
                        method.parameters.overrides,
                        (method.settings.index(variant) for variant in method.parameters.variants()[1:]),
                        strict=True,
                    )
                ]
            ),
            "calibration_no": _chosen(
                [
                    (_pattern("asset", asset), None, number)
                    for number, asset in enumerate(method.calibration.overrides, start=1)
                ]
            ),
            "pool_no": _chosen(
                [
                    (_pattern("asset", asset), None, number)
                    for number, group in enumerate(method.calibration.pools, start=1)
                    for asset in group
                ]
            ),
        },
    )
    for name in ("timeline", "samples", "recounted", "series"):
        _add(steps, f"source/{name}")
    _add(steps, "calibration/limits", {"long_ago": LONG_AGO})
    _add(steps, "calibration/calibration")
    _add(steps, "calibration/calibrated")


def add_calibration(steps: Pipeline, method: Method, number: int) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    setting = method.settings[number]
    _add(
        steps,
        "support/bounds",
        {"settings_no": number, "bins": setting.bins, "window": setting.window},
        name=method.named("bounds", number),
    )
    add_breaks(steps, method, number)
    if method.gaps[number] is None and all(len(rule.allowed) <= 1 for rule in method.rules):
        codes = {"code": _code(setting)}
        _add_of_set(steps, method, number, "calibration/calibration_codes", codes)
        add_short_vectors(steps, method, number, "calibration_")
        vectors, learnable = "vectors", "calibration/learnable_short"
    else:
        add_vectors(steps, method, number, "calibration_", _until_calibration_end())
        vectors, learnable = "marked_vectors", "calibration/learnable"
    _add_of_set(
        steps,
        method,
        number,
        learnable,
        name="learnable",
        tables={vectors: "calibration_vectors"},
    )
    _add_of_set(steps, method, number, "support/support")


def add_breaks(steps: Pipeline, method: Method, number: int) -> None:
    """Add where segments begin, for one set."""
    gap = method.gaps[number]
    if gap is None:
        _add(steps, "source/unbroken", name=method.named("breaks", number))
    else:
        _add(
            steps,
            "source/breaks",
            {"settings_no": number, "max_gap": gap},
            name=method.named("breaks", number),
        )


def add_vectors(steps: Pipeline, method: Method, number: int, prefix: str, read: exp.Expr) -> None:
    """Add the complete form of codes and vectors of one set (Eq. 1) over the samples to be read.

    The vectors of calibration are called ``calibration_vectors``, the others ``marked_vectors``.
    """
    setting = method.settings[number]
    codes = f"{prefix or 'marked_'}codes"
    _add_of_set(
        steps, method, number, "support/marked_codes", {"code": _code(setting), "read": read}, codes
    )
    ks = range(1, setting.m)
    delayed = [_delayed(name, k, setting) for name in ("code", "calibrating") for k in ks]
    touching = exp.or_(
        *(
            exp.EQ(this=exp.column(f"calibrating_{k}"), expression=exp.Literal.number(1))
            for k in range(setting.m)
        )
    )
    _add_of_set(
        steps,
        method,
        number,
        "embedding/marked_vectors",
        {
            **_cell_slots(setting),
            "delayed": delayed,
            "touching": touching,
            "long_ago": LONG_AGO,
        },
        f"{prefix or 'marked_'}vectors",
        {"marked_codes": codes},
    )


def add_short_vectors(steps: Pipeline, method: Method, number: int, prefix: str) -> None:
    """Add the vectors of one set (Eq. 1) over the codes of the same prefix, where no segment ends."""
    setting = method.settings[number]
    _add_of_set(
        steps,
        method,
        number,
        "embedding/vectors",
        {
            **_cell_slots(setting),
            "delayed": [_delayed("code", k, setting) for k in range(1, setting.m)],
        },
        f"{prefix}vectors",
        {"codes": f"{prefix}codes"},
    )


def add_scoring(steps: Pipeline, method: Method, number: int) -> None:
    """Add Eq. 4 and the running counts of Eq. 2 of one set, a row per scored vector."""
    add_vectors(steps, method, number, "", exp.true())
    _add_of_set(steps, method, number, "score/monitored")
    _add_of_set(steps, method, number, "score/novelty", {"carried": [_carried("straddling")]})
    _add_of_set(steps, method, number, "health/numbered")
    _add_of_set(
        steps, method, number, "health/window_counts", {"window": method.settings[number].window}
    )


def add_buckets(steps: Pipeline, method: Method, number: int) -> None:
    """Add Eq. 4 and Eq. 2 at bucket ends of one set, and the novel cells of each bucket.

    Where no segment ends and every channel is scored from the end of its calibration on, the short
    form of the vectors gives the same buckets from half the columns.
    """
    setting = method.settings[number]
    if method.gaps[number] is None and all(rule.score_from is None for rule in method.rules):
        add_short_scoring(steps, method, number)
        parts = ["complete_novelty", "incomplete_numbered"]
    else:
        parts = ["numbered"]
    columns = ("channel_id", "time", "number", "cell_key", "novel", "out_of_range")
    steps.add(
        method.named("placed", number),
        union_of(steps, [method.named(part, number) for part in parts], columns),
        "Placed: every scored vector with its number.",
    )
    stride = setting.bucket_length
    _add_of_set(steps, method, number, "health/kept", {"stride": stride})
    _add_of_set(steps, method, number, "health/buckets")
    _add_of_set(
        steps,
        method,
        number,
        "health/bucket_counts",
        {"buckets": setting.window // stride, "window": setting.window},
    )
    _add_of_set(steps, method, number, "health/novel_cells")


def add_short_scoring(steps: Pipeline, method: Method, number: int) -> None:
    """Add the short form of Eq. 1 and Eq. 4, apart for channels with and without missing samples."""
    setting = method.settings[number]
    _add_of_set(steps, method, number, "score/run_up", {"span": setting.span})
    missing = exp.column("missing_readings", table="scale")
    none = exp.Literal.number(0)
    for prefix, read in (
        ("complete_", exp.EQ(this=missing, expression=none)),
        ("incomplete_", exp.GT(this=missing, expression=none)),
    ):
        _add_of_set(
            steps,
            method,
            number,
            "support/codes",
            {"code": _code(setting), "read": read},
            f"{prefix}codes",
        )
        add_short_vectors(steps, method, number, prefix)
    _add_of_set(
        steps,
        method,
        number,
        "score/monitored_complete",
        {"span": setting.span},
        "complete_monitored",
        {"vectors": "complete_vectors"},
    )
    _add_of_set(
        steps,
        method,
        number,
        "score/monitored_short",
        name="incomplete_monitored",
        tables={"vectors": "incomplete_vectors"},
    )
    for prefix, carried in (
        ("complete_", _carried("number")),
        ("incomplete_", exp.alias_(exp.cast(exp.null(), "INT"), "straddling")),
    ):
        _add_of_set(
            steps,
            method,
            number,
            "score/novelty",
            {"carried": [carried]},
            f"{prefix}novelty",
            {"monitored": f"{prefix}monitored"},
        )
    _add_of_set(
        steps,
        method,
        number,
        "health/numbered",
        name="incomplete_numbered",
        tables={"novelty": "incomplete_novelty"},
    )


def add_certificate(steps: Pipeline, method: Method, number: int) -> None:
    """Add what calibration says about itself, for one set (section 5)."""
    setting = method.settings[number]
    _add_of_set(steps, method, number, "certificate/learnt", {"window": setting.window})
    for name in ("visits", "block_sizes", "cells", "blocks", "learning"):
        _add_of_set(steps, method, number, f"certificate/{name}")
    levels = [
        filled(
            "certificate/levels",
            {"level": level, "divisor": 2**level, "level_bins": -(-setting.bins // 2**level)},
        )
        for level in range(setting.bins.bit_length() + 1)
        if level == 0 or -(-setting.bins // 2**level) >= 2
    ]
    _add_stacked(steps, method.named("levels", number), "certificate/levels", levels)
    radix, top = setting.radix, setting.m - 1
    coarse = [
        template.fill("certificate/coarse_term", {"weight": radix**k, "above": radix ** (k + 1)})
        for k in range(top)
    ]
    coarse.append(template.fill("certificate/top_term", {"weight": radix**top}))
    _add_of_set(steps, method, number, "certificate/ladder", {"coarse_key": template.added(coarse)})
    _add_of_set(steps, method, number, "certificate/spread")
    for name in ("finest", "outlook"):
        _add_of_set(
            steps,
            method,
            number,
            f"certificate/{name}",
            {"target_floor": float(setting.target_floor)},
        )
    _add_of_set(steps, method, number, "certificate/missing_vectors")


def join_sets(steps: Pipeline, method: Method, names: Sequence[str]) -> None:
    """Put the rows of all sets under one another; with one set there is nothing to do."""
    if len(method.settings) > 1:
        for name in names:
            parts = [method.named(name, number) for number in range(len(method.settings))]
            steps.add(name, union_of(steps, parts), f"{name}: the rows of all sets of parameters.")


def add_results(steps: Pipeline, method: Method) -> None:
    """Add the last steps: names and instants instead of integers, and the only divisions."""
    _add(steps, "health/health_indicator", {"time": method.instant_of(_counted("time"))})
    edges = {name: method.instant_of(_counted(name)) for name in ("first_time", "last_time")}
    _add(steps, "health/bucket_health", edges)
    _add(steps, "certificate/support_summary")
    _add(steps, "certificate/certificate", edges)


def _add(
    steps: Pipeline,
    path: str,
    slots: Mapping[str, template.Slot] | None = None,
    name: str | None = None,
    tables: Mapping[str, str] | None = None,
) -> None:
    steps.add(
        name or path.rpartition("/")[2],
        filled(path, slots),
        template.load(path).comment,
        tables,
    )


def _add_of_set(
    steps: Pipeline,
    method: Method,
    number: int,
    path: str,
    slots: Mapping[str, template.Slot] | None = None,
    name: str | None = None,
    tables: Mapping[str, str] | None = None,
) -> None:
    """Add a step of one set, reading the steps of the same set where there are such."""
    query = filled(path, slots)
    inputs = {}
    for table in query.find_all(exp.Table):
        step = (tables or {}).get(table.name, table.name)
        own = method.named(step, number)
        inputs[table.name] = own if own in steps.steps else step
    own_name = method.named(name or path.rpartition("/")[2], number)
    steps.add(own_name, query, template.load(path).comment, inputs)


def _add_stacked(steps: Pipeline, name: str, path: str, rows: Sequence[exp.Query]) -> None:
    query = rows[0] if len(rows) == 1 else exp.union(*rows, distinct=False)
    steps.add(name, query, template.load(path).comment)


def _code(setting: Parameters) -> exp.Expr:
    """Return support/code.sql cast to the narrowest integer: it is what a window has to sort."""
    largest = setting.bins + 2
    narrow = "SMALLINT" if largest < 2**15 else "INT" if largest < 2**31 else "BIGINT"
    return exp.cast(template.fill("support/code", {"bins": setting.bins}), narrow)


def _cell_slots(setting: Parameters) -> dict[str, template.Slot]:
    coordinates = [exp.column(f"code_{k}") for k in range(setting.m)]
    return {
        "span": setting.span,
        "known": exp.and_(*(template.fill("embedding/known", {"code": code}) for code in coordinates)),
        "cell_key": template.added(
            [
                template.fill("embedding/cell_term", {"code": code, "weight": setting.radix**k})
                for k, code in enumerate(coordinates)
            ]
        ),
        "outside": exp.or_(
            *(
                template.fill("embedding/outside", {"code": code, "above": setting.bins + 2})
                for code in coordinates
            )
        ),
    }


def _delayed(name: str, k: int, setting: Parameters) -> exp.Expr:
    delay = template.fill("embedding/delayed", {"column": exp.column(name), "delay": k * setting.tau})
    return exp.alias_(delay, f"{name}_{k}")


def _carried(name: str) -> exp.Expr:
    return exp.alias_(exp.column(name, table="vector"), name)


def _until_calibration_end() -> exp.Expr:
    return exp.LTE(
        this=exp.column("time", table="sampled"),
        expression=exp.column("calibration_end", table="scale"),
    )


def _counted(name: str) -> exp.Expr:
    return exp.column(name, table="counted")


def _chosen(cases: Sequence[tuple[exp.Expr | None, exp.Expr | None, int]]) -> exp.Expr:
    """Return the number of the first case whose conditions hold, else 0; None always holds."""
    chosen = exp.Case(ifs=[], default=exp.Literal.number(0))
    for first, second, number in cases:
        conditions = [condition for condition in (first, second) if condition is not None]
        if not conditions:
            chosen.set("default", exp.Literal.number(number))
            break
        chosen.append("ifs", exp.If(this=exp.and_(*conditions), true=exp.Literal.number(number)))
    if not chosen.args["ifs"]:
        return chosen.args["default"].copy()  # type: ignore[no-any-return]
    return chosen


def _pattern(column: str, pattern: str) -> exp.Expr | None:
    """Return the condition that a name matches a pattern; None for one that matches all."""
    if not pattern.strip("*"):
        return None if pattern else exp.EQ(this=exp.column(column), expression=template.text(""))
    if "*" not in pattern and "?" not in pattern:
        return exp.EQ(this=exp.column(column), expression=template.text(pattern))
    escaped = "".join(
        {"*": "%", "?": "_"}.get(sign, f"!{sign}" if sign in "%_!" else sign) for sign in pattern
    )
    like = exp.Like(this=exp.column(column), expression=template.text(escaped))
    return exp.Escape(this=like, expression=template.text("!"))
