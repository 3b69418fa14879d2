"""Calibrating: new versions of channels, frozen with what calibration taught.

This module owns which channels need a version, and what each is taught.
"""

import dataclasses
import hashlib
from collections.abc import Mapping, Sequence
from typing import Any

import pyarrow as pa

from gam_db.alarms import Alarms
from gam_db.clock import LONG_AGO, Instant
from gam_db.columns import COUNT, SHARE, TRUTH, WORD, columns, name_of, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, place
from gam_db.errors import CalibrationError
from gam_db.method import Method
from gam_db.method.adding import add
from gam_db.method.alarms import NEAR, add_learnt_limits
from gam_db.method.judgement import add_judged
from gam_db.method.programs import weight_of
from gam_db.method.source import add_source
from gam_db.settings.calibration import Calibration, subtract
from gam_db.settings.parameters import ROBUST, Parameters, pattern_matches
from gam_db.settings.source import Programs
from gam_db.stored.draft import Draft
from gam_db.stored.planning import Row, by, whole_pools
from gam_db.stored.sources import described
from gam_db.stored.state import State, kind_of, now
from gam_db.study import Study

#: The folders of ``sql/`` that decide what the numbers of a version are.
_METHOD = (
    "source",
    "calibration",
    "range",
    "embedding",
    "support",
    "certificate",
    "probe",
    "score",
    "health",
    "program",
)

#: What a checksum is made of: of a version that is being written, the steps that its tables are given.
_SUMMED = {
    "frozen": "version_rows",
    **{f"stored_{part}": f"{part}_rows" for part in ("bounds", "support", "calibration")},
}


def calibrate(
    state: State,
    study: Study,
    name: str,
    alarms: Alarms,
    again: bool = False,
    limit: int | None = None,
    configured: Calibration | None = None,
) -> pa.Table:
    """Make a version of every channel that has none with these settings (method, section 4), and limits.

    A pool is calibrated as a whole, and a monitor made if it is not there. What is resolved is frozen: a
    later call with the same settings leaves a version as it is, unless it is asked for ``again``. At
    most ``limit`` readings are worked on at once; None for what memory allows. Where more is taken out
    of the study's calibration than of ``configured``, that is no other setting. Each version without a
    limit gets one, by ``alarms``. All of it is committed together.

    Returns:
        One row per new version, ordered: asset, channel, version_no, reason, m, tau, bins,
        calibrated_lo, calibrated_hi, dropped_below, dropped_above (calibration samples that were left
        out of that range), lowest_dropped, highest_dropped (those farthest from it),
        usual_low, usual_middle, usual_high (one in twenty values lies below, the middle one, one in
        twenty above), verdict, sees, sees_half_stroke, sees_frozen, sees_faster, sees_slower,
        would_not_see, blind_reason, vouched_by, taught_by, member_floor (as :func:`gam_db.support`),
        floor, floor_sd, floor_max, vectors (of
        calibration), cells, blocks, finest_bins, vectors_needed, hi_limit, limit_reason, status (setup,
        waiting or not assessed, since nothing is scored yet), needs_attention, left_out (how many
        intervals were taken out beside what the user gave).

    Raises:
        UserError: the source or the calibration cannot be used, or the monitor watches a source that
            tells time in another way.
    """
    running, steps = study.running, study.steps
    keys = state.keys()
    monitor = _monitor(state, study, name, keys)
    add(steps, "stored/calibrating/repeating_calibration")
    add(steps, "stored/scoring/recount", tables={"calibration": "repeating_calibration"})
    add(steps, "stored/calibrating/first_count")
    add_judged(steps, "limited", "unscored")
    stamps = {"long_ago": LONG_AGO, "created": now()}
    add(steps, "stored/calibrating/version_rows", stamps, tables={"recount": "first_count"})
    add_learnt_limits(steps, study.method, ())
    for part in ("calibration", "bounds", "block", "ladder", "probe", "support", "buffered", "band"):
        add(steps, f"stored/calibrating/{part}_rows")
    if study.method.programs is not None:
        add(steps, "stored/calibrating/program_rows")
    add(steps, "stored/calibrating/extent_rows", {"g": NEAR})
    add(steps, "stored/calibrating/checksum_rows", tables=_SUMMED)
    versions = {
        name_of(row): row
        for row in state.rows("stored/state/active", {"monitor_id": monitor["monitor_id"]})
    }
    # Keys, and so the numbers of episodes, go by names, whatever order an engine gives rows in.
    channels = sorted(running.rows("channels"), key=name_of)
    method = (
        study.method if configured is None else dataclasses.replace(study.method, calibration=configured)
    )
    for row in channels:
        number = number_of(row["asset"], method.assets)
        row["hash"] = settings_hash(method, {**row, "calibration_no": number})
        row["said"] = method.rules[number]
    due = _due(channels, versions, again)
    learnt: list[Row] = []
    names = running.tables["names"]
    readings = {name_of(row): row["readings"] for row in channels}
    at_once = state.session.rows_at_once()
    groups = list(whole_pools(due, readings, limit or at_once * study.taught_at_once))
    # What calibration says of each channel goes into four tables.
    steps.small |= {*study.method.probed(), "certified"}
    if not study.is_ordered and (len(groups) > 1 or not study.method.kind.is_counter):
        # Five steps read a group's rows. Unless the engine can leave out what they do not need (other
        # groups, or what follows calibration, which it cannot tell by timestamps), they are copied once.
        steps.small |= {"identified"}
    with Draft(state, keys) as draft:
        for group in groups:
            study.begin_anew()
            with state.session.lent(table_of(group, _NAMED)) as wanted:
                query = filled("stored/calibrating/wanted_names")
                place(query, {"names": names, "wanted": wanted})
                running.tables["names"] = state.session.keep("wanted_names", query)
                learnt += _learn(draft, study, monitor, group, versions)
                state.session.forget(running.tables["names"])
            running.tables["names"] = names
        running.on_step("limits")
        draft.publish(name, alarms, study.method.requested or study.method.parameters)
    learnt.sort(key=name_of)
    return table_of(learnt, _RESULT)


def without(
    calibration: Calibration, spans: Mapping[str, Sequence[tuple[Instant, Instant]]]
) -> Calibration:
    """Return a rule from which closed intervals of single assets are taken out besides.

    Who teaches stays as it was: an asset that gets a rule of its own here is not named as healthy by it.
    """
    general = dataclasses.replace(calibration, overrides={}, pool=None, reference=())
    cases = {pattern: general if rule is calibration else rule for pattern, rule in calibration.cases}
    overrides: dict[str, Calibration | None] = {}
    for asset, cut in spans.items():
        number = number_of(asset, tuple(cases))
        rule = tuple(cases.values())[number - 1] if number else general
        if rule is not None:
            overrides[asset] = dataclasses.replace(rule, exclude=(*rule.exclude, *cut))
    if not overrides:
        return calibration
    others = {asset: rule for asset, rule in cases.items() if asset not in overrides}
    reference = () if calibration.pool is None else ("*",)
    return dataclasses.replace(calibration, overrides={**overrides, **others}, reference=reference)


def number_of(asset: str, patterns: Sequence[str]) -> int:
    """Return which rule an asset has: 0 for the general one, else the place of its pattern, from 1."""
    matches = (number for number, pattern in enumerate(patterns, 1) if pattern_matches(pattern, asset))
    return next(matches, 0)


def settings_hash(method: Method, channel: Mapping[str, Any]) -> str:
    """Return a hash of the settings of a channel, to compare with that of its version.

    Of the channel must be known: asset, channel, settings_no and calibration_no.
    """
    pools = (patterns for patterns in method.calibration.pools if number_of(channel["asset"], patterns))
    pool = next(pools, None)
    setting = method.settings[channel["settings_no"]]
    figures = _figures(setting, method.gaps[channel["settings_no"]])
    if method.requested is not None:  # what calibration chooses anew each time is no other setting
        configured = method.requested.of(*name_of(channel))
        figures |= {"m": configured.m, "tau": configured.tau, "bins": configured.bins}
        figures |= {"window_length": configured.window, "stride": configured.stride}
    if setting.still_after is None:  # older versions know nothing of it
        del figures["still_after"]
    if setting.least_vectors == Parameters().least_vectors:  # likewise
        del figures["least_vectors"]
    if setting.range != ROBUST:  # likewise
        del figures["is_robust"]
    if method.programs is not None:  # likewise
        figures["program"] = method.programs.column
    hashed = (figures, method.rules[channel["calibration_no"]], pool)
    return hashlib.sha256(repr(hashed).encode()).hexdigest()[:16]


def differing(
    state: State,
    name: str,
    parameters: Parameters,
    calibration: Calibration,
    program: str | None = None,
) -> list[tuple[str, str]]:
    """Return asset and channel of the active versions that were made under other settings than these.

    The program is the column that says which one a machine runs.

    Raises:
        UserError: there is no such monitor, or a length does not fit how it tells time.
    """
    monitor = state.monitor(name)
    programs = None if program is None else Programs(program)
    kind = kind_of(monitor)
    method = Method(parameters.finest(), calibration, kind, parameters, programs=programs)
    rows = state.rows("stored/state/active", {"monitor_id": monitor["monitor_id"]})
    names = table_of([{**row, "readings": 1, "missing_readings": 0} for row in rows], _COUNTED)
    steps = Pipeline()
    add_source(steps, method)
    with state.session.lent(names) as lent:
        chosen = state.session.rows(steps.query("channels", {"names": lent}))
    wanted = {name_of(row): settings_hash(method, row) for row in chosen}
    stored = {name_of(row): row["settings_hash"] for row in rows}
    return sorted(channel for channel, hashed in stored.items() if wanted[channel] != hashed)


def method_hash() -> str:
    """Return a hash of the method, to compare with that of a version."""
    digest = hashlib.sha256()
    for path in sorted(template.sql_folder().glob("*/*.sql")):
        if path.parent.name in _METHOD:
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _figures(setting: Parameters, gap: int | None) -> Row:
    return {
        "m": setting.m,
        "tau": setting.tau,
        "bins": setting.bins,
        "window_length": setting.window,
        "stride": setting.bucket_length,
        "max_gap": gap,
        "still_after": setting.still_after,
        "least_vectors": setting.least_vectors,
        "target_floor": float(setting.target_floor),
        "is_robust": int(setting.range == ROBUST),
    }


def _monitor(state: State, study: Study, name: str, keys: dict[str, int]) -> Row:
    kind = study.method.kind.value
    rows = state.monitors()
    for row in rows:
        if row["name"] == name:
            if row["time_kind"] != kind:
                raise CalibrationError(
                    f"The monitor {name!r} watches a source whose time is a {row['time_kind']}; this "
                    f"source's time is a {kind}. Give the monitor of this source another name."
                )
            return row
    number = 1 + max((row["monitor_id"] for row in rows), default=0)
    monitor = {"monitor_id": number, "name": name, **described(study.source), "time_kind": kind}
    with state.alone(keys):
        state.append_rows("monitor", [{**monitor, "created": now()}])
    return monitor


def _due(channels: Sequence[Row], versions: Mapping[tuple[str, str], Row], again: bool) -> list[Row]:
    """Return the channels of pools (a channel alone is one) that need versions, with the reason."""
    due: list[Row] = []
    for pool in by("support_id", channels).values():
        for row in pool:
            version = versions.get(name_of(row))
            is_other = version is not None and version["settings_hash"] != row["hash"]
            row["reason"] = "other settings" if is_other else None if version else "first calibration"
        if again or any(row["reason"] for row in pool):
            for row in pool:
                row["reason"] = row["reason"] or ("asked for" if again else "pool changed")
            due += pool
    return due


def _learn(
    draft: Draft,
    study: Study,
    monitor: Row,
    group: Sequence[Row],
    versions: Mapping[tuple[str, str], Row],
) -> list[Row]:
    """Calibrate a group of channels into a draft; return a row for each."""
    running, state = study.running, draft.state
    local = {name_of(row): row for row in running.rows("channels")}
    channel_ids = {
        name_of(row): row["channel_id"]
        for row in state.rows("stored/state/monitor_channels", {"monitor_id": monitor["monitor_id"]})
    }
    last, method, programs = draft.last, method_hash(), study.method.programs
    numbering: list[Row] = []
    channels: list[Row] = []
    for row in group:
        key = name_of(row)
        if key not in channel_ids:
            last["channel"] += 1
            channel_ids[key] = last["channel"]
            ids = {"channel_id": channel_ids[key], "monitor_id": monitor["monitor_id"]}
            channels.append({**ids, "asset": row["asset"], "channel": row["channel"]})
        before = versions.get(key)
        number = row["settings_no"]
        last["version"] += 1
        numbering.append(
            {
                "channel_id": local[key]["channel_id"],
                "stored_channel_id": channel_ids[key],
                "version_id": last["version"],
                "stored_support_id": last["support"] + local[key]["support_id"],
                "parent_id": None if before is None else before["version_id"],
                "version_no": 1 if before is None else before["version_no"] + 1,
                "reason": row["reason"],
                **_figures(study.method.settings[number], study.method.gaps[number]),
                "score_from": study.method.rules[row["calibration_no"]].score_from,
                "program_column": None if programs is None else programs.column,
                "program_weight": None if programs is None else weight_of(study.method.settings[number]),
                "settings_hash": row["hash"],
                "method_hash": method,
            }
        )
    last["support"] = max(row["stored_support_id"] for row in numbering)
    with state.session.lent(table_of(numbering, _NUMBERING)) as loaded:
        running.tables["numbering"] = loaded
        running.on_step("writing")
        draft.add(channels, study)
        learnt = {row["channel_id"]: row for row in running.rows("bounds")}
        for row in running.rows("unscored"):
            learnt[row["channel_id"]] |= row
        study.begin_anew()
        del running.tables["numbering"]
    rows = []
    for row, numbered in zip(group, numbering, strict=True):
        taught, used = learnt[numbered["channel_id"]], study.method.rules[row["calibration_no"]]
        end, gone = taught["calibration_end"], subtract(row["said"].allowed, used.allowed)
        left_out = sum(end is not None and start <= end for start, _ in gone)
        rows.append({**row, **taught, **numbered, "left_out": left_out})
    return rows


_NAMED = columns((WORD, "asset channel"))
_COUNTED = columns((WORD, "asset channel"), (COUNT, "readings missing_readings"))
_NUMBERING = columns(
    (COUNT, "channel_id stored_channel_id version_id stored_support_id parent_id version_no m tau bins"),
    (COUNT, "window_length stride max_gap still_after least_vectors is_robust"),
    (COUNT, "score_from program_weight"),
    (SHARE, "target_floor"),
    (WORD, "reason settings_hash method_hash program_column"),
)
_RESULT = columns(
    (WORD, "asset channel"),
    (COUNT, "version_no"),
    (WORD, "reason"),
    (COUNT, "m tau bins"),
    (SHARE, "calibrated_lo calibrated_hi"),
    (COUNT, "dropped_below dropped_above"),
    (SHARE, "lowest_dropped highest_dropped usual_low usual_middle usual_high"),
    (WORD, "verdict"),
    (COUNT, "sees sees_half_stroke sees_frozen sees_faster sees_slower"),
    (WORD, "would_not_see blind_reason"),
    (COUNT, "vouched_by"),
    (WORD, "taught_by"),
    (SHARE, "member_floor"),
    (SHARE, "floor floor_sd floor_max"),
    (COUNT, "vectors cells blocks finest_bins vectors_needed"),
    (SHARE, "hi_limit"),
    (WORD, "limit_reason status"),
    (TRUTH, "needs_attention"),
    (COUNT, "left_out"),
)
