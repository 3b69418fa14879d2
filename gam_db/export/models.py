"""The models of a dbt package: which steps each is made of, and what dbt has to know of it.

This module owns the way from the files of ``sql/`` to the query of each model. Models bear the names of
the state tables that the stored form keeps, and the same columns as far as they need them: a channel has
one version, so it goes by the channel's number.
"""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from sqlglot import exp

from gam_db import data
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, union_of
from gam_db.engines.base import Engine
from gam_db.errors import CalibrationError, wrong
from gam_db.export import jinja
from gam_db.method import Method, pipeline
from gam_db.method.adding import OfSet, add
from gam_db.method.calibration import add_calibration
from gam_db.method.certificate import add_judgement
from gam_db.method.judgement import add_judged, limit_slots
from gam_db.method.probe import add_certified, add_probe
from gam_db.method.programs import (
    add_judged_programs,
    add_samples,
    add_taught_programs,
    has_programs,
    identified_slots,
)
from gam_db.method.source import add_rules
from gam_db.reading.ahead import latest_live
from gam_db.settings.source import AnySource, under
from gam_db.stored.calibrating import method_hash
from gam_db.stored.planning.setting import Setting
from gam_db.stored.planning.steps import DAY, KEPT, add_counting
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
}

#: The same where states are of programs.
PROGRAM = {"program": ("support_id", "program_no")}

#: The first microsecond of the year 1: no warehouse knows an earlier one.
_FIRST = -62_135_596_800_000_000

_LEARNT = ("limits", "identified", "timeline", "collapsed", "calibrated", "recount")
_PLANNED = ("active", "stored_visible_bucket", "newest", "restart", "cohort", "channels", "bounds")


@dataclass(frozen=True)
class Model:
    """One model, or one test that is a query."""

    name: str  # without the prefix; it is that of a state table where there is one
    folder: str
    about: str  # the template that says what it holds
    query: exp.Query  # what the first build runs
    later: exp.Query | None = None  # what later ones run; None if that is the same
    config: Mapping[str, Any] = field(default_factory=dict)
    keys: tuple[str, ...] = ()  # columns that no two rows share
    values: Mapping[str, Sequence[str]] = field(default_factory=dict)  # column -> those that there are


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
        one, gap = self.method.settings[0], self.method.gaps[0]
        has_start = any(rule.score_from is not None for rule in self.method.rules)
        figures = (one.m, one.tau, one.grid, one.window, one.bucket_length)
        return Setting(*figures, gap, has_start, one.still_after, self.method.programs)

    @property
    def calibrated(self) -> Mapping[str, tuple[str, ...]]:
        """The models that are built once, and the columns that no two rows of each share."""
        return CALIBRATED | (PROGRAM if self.setting.has_programs else {})

    @cached_property
    def settings_hash(self) -> str:
        """What tells whether tables were built under the settings of this package."""
        read = {key: said for key, said in described(self.source).items() if key != "source"}
        read |= self.source.written
        calibration = self.method.calibration
        said = (
            self.setting,
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
        return hashlib.sha256(repr(said).encode()).hexdigest()[:16]

    def reference(self, name: str) -> exp.Table:
        """Return the node that reads a model."""
        return jinja.reference(f"{self.prefix}{name}")

    def readings(self, *conditions: exp.Expr) -> exp.Query:
        """Return the step *readings* under conditions on the source's own columns."""
        source, kind = under(self.source, *conditions), self.method.kind
        until = latest_live(source, self.engine, kind)
        return self.engine.readings(source, _SOURCE_NODE, kind, until=until)

    def instant(self, time: exp.Expr) -> exp.Expr:
        """Return an integer time as the source tells it."""
        return self.engine.instant_of(self.method.kind, time)

    @property
    def margin(self) -> int:
        """How far bounds are moved outwards that only spare the warehouse work.

        A timestamp without zone beside one with a zone may be read in the zone of the session.
        """
        return 0 if self.method.kind.is_counter else DAY


_SOURCE_NODE = jinja.source(SOURCE, TABLE)


def models(of: Modelled) -> list[Model]:
    """Return the models of a package, each after those that it reads."""
    return [*_calibration(of), _bucket(of), *_views(of)]


def checks(of: Modelled) -> list[Model]:
    """Return the tests of a package that are queries of their own; a row is something amiss."""
    steps = _learning(of)
    add(steps, "source/names")
    add(steps, "stored/scoring/recount")
    placed = {"stored_channel": of.reference("channel"), "calibration": of.reference("calibration")}
    made = []

    def check(name: str, step: str) -> None:
        about, config = f"export/{step}", {"severity": "warn"}
        add(steps, about)
        query = steps.query(step, placed, commented=True)
        made.append(Model(name, "tests", about, query, config=config))

    check("calibration_is_unchanged", "changed_calibration")
    check("channels_are_known", "unknown_channels")
    if of.setting.has_programs:
        placed["programs"] = of.reference("program")
        steps.replace("readings", of.readings())  # of all rows, not of those of calibration alone
        check("programs_are_judged", "unjudged_programs")
    return made


def _calibration(of: Modelled) -> list[Model]:
    """Return the models that are built once: a later build leaves their rows as they are."""
    steps = pipeline(of.method, of.readings(), of.instant)
    add(steps, "stored/scoring/recount")
    hashes = {"settings_hash": of.settings_hash, "method_hash": method_hash()}
    slots: dict[str, template.Slot] = {key: template.text(said) for key, said in hashes.items()}
    slots |= {"span": of.method.settings[0].reach, "long_ago": LONG_AGO}
    learning = _learning(of)
    placed = {"stored_channel": of.reference("channel"), "calibration": of.reference("calibration")}
    verdicts = ["ready", "blind", "too_fine", "needs_data", "constant", "no_data"]
    values = {"channel": {key: [said] for key, said in hashes.items()}, "bounds": {"verdict": verdicts}}
    config = {"materialized": "incremental", "incremental_strategy": "append"}
    config |= of.adapter.get("config", {})
    made = []
    for name, keys in of.calibrated.items():
        about = f"{'export' if name in ('channel', 'calibration') else 'stored/calibrating'}/{name}_rows"
        if name == "channel":
            add(steps, about, slots)
            query = steps.query("channel_rows", commented=True)
        else:
            add(learning, about, tables=None if name == "calibration" else {"numbering": "channels"})
            query = learning.query(f"{name}_rows", placed, commented=True)
            query.set("order", None)
        columns = [exp.column(exp.to_identifier(column)) for column in query.named_selects]
        nothing = exp.select(*columns).from_(jinja.THIS.copy()).where(exp.Literal.number(1).eq(0))
        of_name = values.get(name, {})
        made.append(Model(name, "models/calibration", about, query, nothing, config, keys, of_name))
    return made


def _learning(of: Modelled) -> Pipeline:
    """Return the steps that learn, over the channels and intervals of the package's own models."""
    steps = Pipeline(small=frozenset(of.method.small() | set(_LEARNT)))
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
    add_rules(steps, of.method)
    steps.add("readings", rows, template.load("source/readings").comment)
    add(steps, "source/identified", identified_slots(exp.true(), has_programs(rows)))
    add(steps, "stored/scoring/repeats", name="timeline")
    add_samples(steps, of.method.programs)
    add(steps, "calibration/calibrated")
    add_taught_programs(steps, of.method.programs)
    one = OfSet(steps, of.method, 0)
    add_calibration(one)
    add_judgement(one)
    add_judged_programs(one)
    add_probe(one)
    add_certified(steps, bool(of.method.pools), of.setting.has_programs)
    return steps


def _bucket(of: Modelled) -> Model:
    """Return the model that grows: a later build reads what is new, by the restart rule."""
    names = ("channel", "bounds", "support", *["program"] * of.setting.has_programs)
    placed = {f"stored_{name}": of.reference(name) for name in names}
    placed["calibration"] = of.reference("calibration")
    first = _scoring(of, is_later=False).query("bucket_rows", placed, commented=True)
    steps = _scoring(of, is_later=True)
    steps.add("rows", union_of(steps, ["bucket_rows", "ended_buckets"]))
    later = steps.query("rows", {**placed, "stored_bucket": jinja.THIS}, commented=True)
    ended = exp.delete(jinja.THIS.copy(), where=exp.column("last_time").is_(exp.null()))
    keys = ("channel_id", "bucket_no")
    config = {
        "materialized": "incremental",
        "incremental_strategy": of.adapter.get("strategy", "delete+insert"),
        "unique_key": list(keys),
        **of.adapter.get("config", {}),
        "post_hook": of.engine.text(ended),
    }
    return Model("bucket", "models/health", "export/bucket_rows", first, later, config, keys)


def _scoring(of: Modelled, is_later: bool) -> Pipeline:
    setting = of.setting
    steps = Pipeline(small=KEPT | set(_PLANNED))
    add(steps, "export/active", {"window": setting.window_length, "stride": setting.stride})
    conditions: list[exp.Expr] = []
    if is_later:
        add(steps, "export/visible_bucket", name="stored_visible_bucket")
        add(steps, "stored/state/newest")
        never = {"repair_from": FAR_AHEAD, "pruned_stay": 0}
        add(steps, "stored/scoring/restart", {"lookback": of.lookback, **never})
        add(steps, "export/cohort", {"far_ahead": FAR_AHEAD})
        bounds = {"margin": of.margin, "earliest": LONG_AGO if of.method.kind.is_counter else _FIRST}
        earliest = exp.Subquery(this=filled("export/earliest", bounds))
        time = template.column(of.source.time)
        conditions.append(exp.GTE(this=time, expression=of.instant(earliest)))
    else:
        # All readings flow past: keeping those of years would cost more than reading them again.
        steps.small -= {"identified"}
        add(steps, "export/whole_cohort", {"far_ahead": FAR_AHEAD}, name="cohort")
    add(steps, "stored/scoring/channels")
    add(steps, "stored/scoring/bounds", {"settings": []})
    add(steps, "stored/scoring/support")
    rows = of.readings(*conditions)
    steps.add("readings", rows, template.load("source/readings").comment)
    edges = [exp.column(name, table="named") for name in ("read_from", "read_until")]
    within = exp.column("time", table="reading").between(edges[0], edges[1])
    add(steps, "source/identified", identified_slots(within, has_programs(rows)))
    add_counting(steps, setting, of.method.kind, has_past=is_later)
    add(steps, "export/bucket_rows")
    if is_later:
        add(steps, "export/ended_buckets")
    return steps


def _views(of: Modelled) -> list[Model]:
    names = ("channel", "bounds", "bucket", *["block"] * bool(of.method.pools))
    placed = {f"stored_{name}": of.reference(name) for name in names}
    steps = Pipeline()
    add(steps, f"export/{'vouched' if of.method.pools else 'certified'}", name="certified")
    limits = limit_slots(template.node_of(float(of.method.settings[0].target_floor)))
    add(steps, "export/assessed", {**limits, "stride": of.setting.stride})
    add_judged(steps)
    made, hook = [], {"pre_hook": of.adapter["before"]} if "before" in of.adapter else {}
    of_limit: dict[str, template.Slot] = {"hi_limit": limits["hi_limit"]}
    of_window: dict[str, template.Slot] = {"window": of.setting.window_length}
    for name, times_of, slots, keys in (
        ("health", ("first_time", "last_time"), of_limit, ("asset", "channel", "bucket")),
        ("fleet", ("last_tick", "since_tick"), of_window, ("asset", "channel")),
        ("machine", ("since_tick", "last_tick"), {}, ("asset",)),
    ):
        times: list[exp.Expr] = []
        if not of.method.kind.is_counter:
            times = [
                exp.alias_(of.instant(exp.column(column, table="made")), column.replace("tick", "time"))
                for column in times_of
            ]
        add(steps, f"export/{name}", {"times": times, **slots})
        query = steps.query(name, placed)
        config = {"materialized": "view", **hook}
        made.append(Model(name, "models/health", f"export/{name}", query, config=config, keys=keys))
    return made
