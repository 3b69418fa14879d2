"""The models of a dbt package: the steps of each, and its configuration for dbt.

This module owns the way from the files of ``sql/`` to the steps of a package. Its tables bear the names
of the state tables that the stored form keeps, and the same columns as far as they need them: a channel
has one version, so it goes by the channel's number. How steps become files is
:mod:`gam_db.export.modelling`.
"""

import hashlib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from sqlglot import exp

from gam_db import data
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, Step, filled, union_of
from gam_db.engines.base import Engine
from gam_db.errors import CalibrationError, wrong
from gam_db.export import jinja
from gam_db.method import Method
from gam_db.method.adding import OfSet, add
from gam_db.method.calibration import add_calibration
from gam_db.method.certificate import add_judgement
from gam_db.method.judgement import add_judged, limit_slots
from gam_db.method.parts import LEFT_OUT, PARTS
from gam_db.method.probe import add_certified, add_probe
from gam_db.method.programs import (
    JUDGED,
    add_judged_programs,
    add_taught_programs,
    gathered,
    identified_slots,
)
from gam_db.method.ranges import DROPPED, is_robust
from gam_db.method.scoring import add_buckets, add_numbered
from gam_db.method.source import add_channels, add_rules
from gam_db.reading.ahead import latest_live
from gam_db.settings.source import AnySource, under
from gam_db.stored.calibrating import method_hash
from gam_db.stored.planning.setting import Setting
from gam_db.stored.planning.steps import DAY, ENDS, method_of
from gam_db.stored.sources import described

#: What dbt runs on, by engine; see the file.
ADAPTERS: Mapping[str, Mapping[str, Any]] = data.table("gam_db.export", "adapters.toml")

SOURCE, TABLE = "gam_source", "telemetry"

#: The models that are built once, and the columns that no two rows of each share.
CALIBRATED = {
    "channel": ("channel_id",),
    "calibration": ("channel_id", "time_from"),
    "bounds": ("support_id",),
    "support": ("support_id", "cell_key"),
    "block": ("support_id", "block"),
    "ladder": ("support_id", "bins"),
    "probe": ("support_id", "change_no"),
    "program": ("support_id", "program_no"),
}

#: The views for whoever reads on, with the columns that no two rows of each share.
VIEWS = {
    "health": ("asset", "channel", "bucket"),
    "fleet": ("asset", "channel"),
    "machine": ("asset",),
}

#: The tests that are queries, by the step whose rows are something amiss.
CHECKS = {
    "changed_calibration": "calibration_is_unchanged",
    "unknown_channels": "channels_are_known",
    "unjudged_programs": "programs_are_judged",
}

#: The step that reads what the build before left.
EARLIER = "earlier_bucket"

#: What a pool says of members that taught nothing.
_MEMBER = ("verdict", "floor", "floor_sd", "floor_max", "finest_bins")

#: The first microsecond of the year 1: no warehouse knows an earlier one.
_FIRST = -62_135_596_800_000_000


@dataclass(frozen=True)
class Modelled:
    """What the models are made from: a method with fixed calibration and one set of parameters.

    Raises:
        CalibrationError: calibration is no list of intervals.
        ParameterError: some channels have other parameters.
    """

    source: AnySource
    method: Method
    engine: Engine
    adapter: Mapping[str, Any]
    prefix: str
    lookback: int
    parts: Collection[str] = PARTS  # of the certificate

    def __post_init__(self) -> None:
        calibration = self.method.calibration
        rules = [calibration, *(rule for rule in calibration.overrides.values() if rule is not None)]
        if any(rule.intervals is None for rule in rules):
            raise wrong("dbt_calibration_not_fixed")
        if not any(rule.allowed for rule in self.method.rules):
            raise CalibrationError("Nothing is left of the calibration intervals; give at least one.")
        if len(self.method.settings) > 1:
            raise wrong("dbt_several_sets")

    @property
    def setting(self) -> Setting:
        """The parameters of all channels."""
        parameters, gap = self.method.settings[0], self.method.gaps[0]
        figures = (
            parameters.m,
            parameters.tau,
            parameters.grid,
            parameters.window,
            parameters.bucket_length,
        )
        return Setting(*figures, gap, True, parameters.still_after, self.method.programs)

    @property
    def calibrated(self) -> Mapping[str, tuple[str, ...]]:
        """The models that are built once, and the columns that no two rows of each share."""
        absent = {"probe": "probe" not in self.parts, "program": not self.setting.has_programs}
        return {name: keys for name, keys in CALIBRATED.items() if not absent.get(name)}

    @cached_property
    def settings_hash(self) -> str:
        """A hash that shows whether tables were built under the settings of this package."""
        read = {key: text for key, text in described(self.source).items() if key != "source"}
        read |= self.source.written
        calibration = self.method.calibration
        settings = (
            self.setting,
            sorted(self.parts),
            float(self.method.settings[0].target_floor),
            self.method.settings[0].least_vectors,
            self.method.settings[0].range,
            self.method.rules,
            tuple(calibration.overrides),
            calibration.pools,
            sorted(read.items(), key=lambda item: item[0]),
            self.source.value_columns,
            self.method.kind.value,
        )
        return hashlib.sha256(repr(settings).encode()).hexdigest()[:16]

    def reference(self, name: str) -> exp.Table:
        """Return the node that reads a model."""
        return jinja.reference(f"{self.prefix}{name}")

    def readings(self, *conditions: exp.Expr) -> exp.Query:
        """Return the step *readings* under conditions on the source's own columns."""
        source, kind = under(self.source, *conditions), self.method.kind
        until = latest_live(source, self.engine, kind)
        return self.engine.readings(source, _SOURCE_NODE, kind, until=until)

    def instant(self, time: exp.Expr) -> exp.Expr:
        """Return an integer time as a time of the source."""
        return self.engine.instant_of(self.method.kind, time)

    @property
    def margin(self) -> int:
        """How far bounds are moved outwards that only spare the warehouse work.

        A timestamp without zone beside one with a zone may be read in the zone of the session.
        """
        return 0 if self.method.kind.is_counter else DAY


_SOURCE_NODE = jinja.source(SOURCE, TABLE)


def package_steps(of: Modelled) -> Pipeline:
    """Return the steps of a package in order: its models, views and tests by their names, and others."""
    package = Pipeline()
    scoring = _scoring(of)
    tables = {*CALIBRATED, *VIEWS, "bucket"}
    reserved = tables | scoring.steps.keys()
    parts: list[tuple[str, Pipeline, dict[str, str]]] = [
        ("channel_", _naming(of), {"channel_rows": "channel"}),
        ("calibration_", _declaring(of), {"calibration_rows": "calibration"}),
        ("calibration_", _learning(of), {f"{name}_rows": name for name in list(of.calibrated)[2:]}),
        ("scored_", scoring, {"bucket_rows": "bucket_rows", "ended_buckets": "ended_buckets"}),
    ]
    for prefix, steps, targets in parts:
        for target in targets:
            if target not in steps.steps:
                add(steps, f"stored/calibrating/{target}", tables={"numbering": "channels"})
        _take(package, steps, targets, tables if steps is scoring else reserved, prefix)
    rows = union_of(package, ["bucket_rows", "ended_buckets"])
    package.add("bucket", rows, template.load("export/bucket_rows").comment)
    views = _views(of)
    _take(package, views, {name: name for name in VIEWS}, tables, "current_")
    checks = _learning(of)
    add(checks, "source/names")
    add(checks, "stored/scoring/recount")
    for step in ("changed_calibration", "unknown_channels"):
        add(checks, f"export/{step}")
        _take(package, checks, {step: step}, reserved, "calibration_")
    if of.setting.has_programs:
        checks.replace("readings", of.readings())  # of all rows, not of those of calibration alone
        add(checks, "export/unjudged_programs", tables={"judged_samples": JUDGED})
        _take(package, checks, {"unjudged_programs": "unjudged_programs"}, reserved, "current_")
    return package


def _take(
    package: Pipeline,
    steps: Pipeline,
    targets: Mapping[str, str],
    reserved: Collection[str],
    prefix: str,
) -> None:
    """Add to a package what the targets need; what has the name of another step gets the prefix."""
    names = {f"stored_{name}": name for name in (*CALIBRATED, "bucket")}
    for step in steps.needed(targets):
        tables = {read: names.get(read, read) for read in step.definition.tables}
        inputs = {read: name for read, name in tables.items() if name in package.steps}
        added = Step.of(step.name, step.query, step.definition.comment, inputs)
        name = targets.get(step.name, step.name)
        if step.name not in targets and (name in reserved or _differs(package, name, added)):
            name = f"{prefix}{name}"
        names[step.name] = name
        if name not in package.steps or _differs(package, name, added):
            package.add(name, step.query, step.definition.comment, tables)


def _differs(package: Pipeline, name: str, step: Step) -> bool:
    """Tell whether another step has the name."""
    return name in package.steps and package.steps[name].query != step.query


def _naming(of: Modelled) -> Pipeline:
    """Return the steps that number the channels; the last one is *channel_rows*."""
    steps = Pipeline()
    rows, method = of.readings(), of.method
    steps.add("readings", rows, template.load("source/readings").comment)
    add(steps, "source/names")
    add_rules(steps, method)
    add_channels(steps, method)
    add(steps, "export/limits", {"long_ago": LONG_AGO})
    _add_samples(steps, of, exp.true())
    add(steps, "export/calibration_rows", name="calibration")
    add(steps, "stored/scoring/recount")
    span = method.settings[0].reach
    add(steps, "export/run_up", {"span": span})
    hashes = {"settings_hash": of.settings_hash, "method_hash": method_hash()}
    slots: dict[str, template.Slot] = {key: template.text(text) for key, text in hashes.items()}
    add(steps, "export/channel_rows", {**slots, "span": span, "long_ago": LONG_AGO})
    return steps


def _declaring(of: Modelled) -> Pipeline:
    """Return the steps that give each channel its calibration; the last one is *calibration_rows*."""
    steps = Pipeline()
    add_rules(steps, of.method)
    add(steps, "export/channels")
    add(steps, "export/calibration_rows")
    return steps


def _learning(of: Modelled) -> Pipeline:
    """Return the steps that learn, over the channels and intervals of the package's own models."""
    steps = Pipeline()
    allowed = [interval for rule in of.method.rules for interval in rule.allowed]
    edges = min(allowed)[0] - of.margin, max(end for _, end in allowed) + 1 + of.margin
    low, high = (of.instant(template.node_of(edge)) for edge in edges)
    time = template.column(of.source.time)
    within = [exp.GTE(this=time, expression=low), exp.LT(this=time.copy(), expression=high)]
    # Samples before calibration decide nothing, unless by standing still.
    rows = of.readings(*(within if of.setting.still_after is None else within[1:]))
    add(steps, "export/channels")
    limits = union_of(steps, ["channels"], ["channel_id", "calibration_end", "first_scored"])
    steps.add("limits", limits, "Limits: when calibration ends, and from when on is scored.")
    steps.add("readings", rows, template.load("source/readings").comment)
    _add_samples(steps, of, exp.true())
    add(steps, "calibration/calibrated")
    add_taught_programs(steps, of.method.programs)
    set_steps = OfSet(steps, of.method, 0)
    add_calibration(set_steps)
    add_judgement(set_steps)
    add_judged_programs(set_steps)
    nothing = exp.select(exp.alias_(exp.null(), "support_id")).where(exp.false())
    if "curve" not in of.parts:
        steps.replace("outlook", nothing)
    if "probe" in of.parts:
        add_probe(set_steps)
    else:
        steps.add("sight", nothing)
    add_certified(steps, bool(of.method.pools), of.setting.has_programs)
    return steps


def _add_samples(steps: Pipeline, of: Modelled, read: exp.Expr) -> None:
    """Add the readings of channels, and their samples, of which each instant has one."""
    has_program = of.setting.has_programs
    add(steps, "source/identified", identified_slots(read, has_program))
    slots: dict[str, template.Slot] = {"gathered": gathered("reading", of.method.programs)}
    add(steps, "export/samples", slots)


def _scoring(of: Modelled) -> Pipeline:
    """Return the steps from the build before to the buckets of this one, by the restart rule."""
    setting, steps = of.setting, Pipeline()
    add(steps, f"export/{EARLIER}")
    add(steps, "export/restart", {"lookback": of.lookback})
    add(steps, "export/cohort", {"far_ahead": FAR_AHEAD})
    for name in ("channels", "bounds"):
        add(steps, f"stored/scoring/{name}", {"settings": []} if name == "bounds" else None)
    bounds = {"margin": of.margin, "earliest": LONG_AGO if of.method.kind.is_counter else _FIRST}
    earliest = exp.Subquery(this=filled("export/earliest", bounds))
    time = template.column(of.source.time)
    rows = of.readings(exp.GTE(this=time, expression=of.instant(earliest)))
    steps.add("readings", rows, template.load("source/readings").comment)
    edges = [exp.column(name, table="named") for name in ("read_from", "read_until")]
    within = exp.Between(this=exp.column("time", table="reading"), low=edges[0], high=edges[1])
    _add_samples(steps, of, within)
    add(steps, "export/seen")
    if setting.has_programs:
        add(steps, "stored/scoring/judged_programs")
        judged = {"numbered_programs": "judged_programs"}
        add(steps, "program/program_samples", name=JUDGED, tables=judged)
    set_steps = OfSet(steps, method_of(setting, of.method.kind), 0)
    has_stillness = setting.still_after is not None
    add_numbered(set_steps, carried=["still_so_far"] * has_stillness)
    add_buckets(set_steps, ENDS | ({"still_so_far": "end_still"} if has_stillness else {}))
    add(steps, "stored/scoring/bucket_ends")
    add(steps, "stored/scoring/new_buckets", {"differing": []})
    add(steps, "export/past_buckets", {"buckets": setting.window_length // setting.stride})
    running = union_of(steps, ["past_buckets", "new_buckets"], ["channel_id", "bucket_no", "novel"])
    comment = "Running buckets: the new ones, after the last window of those that stay."
    steps.add("running_buckets", running, comment)
    set_steps.add("health/bucket_counts", tables={"buckets": "running_buckets"})
    add(steps, "export/bucket_rows")
    add(steps, "export/ended_buckets")
    return steps


def _views(of: Modelled) -> Pipeline:
    """Return the steps of the views."""
    steps = Pipeline()
    certified = {"certified": "channel_limit"}
    file = "vouched" if of.method.pools else "certified"
    add(steps, f"export/{file}", name="channel_certificate")
    limits = limit_slots(template.node_of(float(of.method.settings[0].target_floor)))
    names = steps.steps["channel_certificate"].query.named_selects
    columns = [exp.column(name, table="learnt") for name in names if name != "channel_id"]
    learnt = {"certified": "channel_certificate"}
    add(steps, "export/limited", {**limits, "columns": columns}, "channel_limit", learnt)
    add(steps, "export/assessed", {"stride": of.setting.stride}, tables=certified)
    add_judged(steps)
    of_window: dict[str, template.Slot] = {"window": of.setting.window_length}
    for name, table, times_of, slots in (
        ("health", "bucket_row", ("first_time", "last_time"), {}),
        ("fleet", "judgement", ("last_tick", "since_tick"), of_window),
        ("machine", "machine_row", ("since_tick", "last_tick"), {}),
    ):
        if name == "machine":
            add(steps, "judgement/machines", tables={"signals": "fleet"})
        times: list[exp.Expr] = []
        if not of.method.kind.is_counter:
            tables = {"last_tick": "counted"} if name == "machine" else {}
            times = [
                exp.alias_(
                    of.instant(exp.column(column, table=tables.get(column, table))),
                    column.replace("tick", "time"),
                )
                for column in times_of
            ]
        add(steps, f"export/{name}", {"times": times, **slots}, tables=certified)
    return steps


def left_out(of: Modelled) -> set[str]:
    """Return the columns of models that the settings of a package leave without a value."""
    absent = {column for part, columns in LEFT_OUT.items() if part not in of.parts for column in columns}
    if not is_robust(of.method.settings[0]):
        absent |= set(DROPPED)
    if not of.method.pools:
        absent |= {"teachers", "vouched_by", "taught_by", "vouching"}
        absent |= {f"member_{name}" for name in _MEMBER}
    return absent
