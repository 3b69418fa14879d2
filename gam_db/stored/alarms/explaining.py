"""Explaining episodes: where the signal was in their first judgements (alarms, section 5).

This module owns which rows of the source are read again for that. No other result depends on it: the
next run does what a run did not reach.
"""

from collections.abc import Iterable, Mapping, Sequence
from itertools import zip_longest

from sqlglot import exp

from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.stored.planning import Row, assets_of, portions
from gam_db.stored.planning.reading import Reader, cohort_of, identified, listed
from gam_db.stored.planning.setting import setting_of
from gam_db.stored.planning.steps import explaining_steps
from gam_db.stored.state import State
from gam_db.study.running import Running


def explain(state: State, reader: Reader, monitor_id: int, plan: Iterable[Row], limit: int) -> None:
    """Count where signals were in the first five judgements of episodes, where that is not known yet.

    Only the channels of the plan are read, ``limit`` readings at once at most.
    """
    versions = {row["version_id"]: row for row in plan}
    slots: dict[str, template.Slot] = {"monitor_id": monitor_id}
    raised = state.rows("stored/alarms/raised_versions", slots)
    version_ids = [row["version_id"] for row in raised if row["version_id"] in versions]
    if not version_ids:
        return
    # What is of no use is skipped by an engine where that is said in literals.
    slots["raised_versions"] = listed(exp.column("version_id", table="judged"), version_ids)
    runs: dict[int, list[list[Row]]] = {}  # of judgements that follow one another
    wanted = [
        row for row in state.rows("stored/alarms/uncounted", slots) if row["version_id"] in versions
    ]
    for row in _readable(state, wanted):
        mine = runs.setdefault(row["version_id"], [])
        if mine and mine[-1][-1]["judgement_no"] + 1 == row["judgement_no"]:
            mine[-1].append(row)
        else:
            mine.append([row])
    for together in zip_longest(*runs.values()):  # of one channel one at most
        channels = [_plan_row(judgements, versions) for judgements in together if judgements]
        counts = {name_of(row): 6 * row["window_length"] for row in channels}
        for group in portions(channels, counts, limit, setting_of):
            _count(state, reader, group)


def _readable(state: State, wanted: Sequence[Row]) -> list[Row]:
    """Return the judgements whose previous bucket is stored, with the start of the rows to read."""
    if not wanted:
        return []
    columns = {"version_id": "version_id", "bucket_no": "bucket_before"}
    conditions = (
        listed(exp.column(name, table="full_bucket"), {row[of] for row in wanted})
        for name, of in columns.items()
    )
    buckets = state.rows("stored/alarms/buckets_before", {"wanted": exp.and_(*conditions)})
    ends = {(row["version_id"], row["bucket_no"]): row for row in buckets}
    judgements = []
    for row in wanted:
        end = ends.get((row["version_id"], row["bucket_before"]))
        if end is not None:
            judgements.append(
                {**row, "first_scored": end["last_time"] + 1, "read_from": end["context_time"]}
            )
        elif row["judgement_no"] == 0:
            judgements.append(row)
    return judgements


def _plan_row(judgements: Sequence[Row], versions: Mapping[int, Row]) -> Row:
    """Return what a run reads for some judgements, as a row of the plan."""
    first = judgements[0]
    edges = {name: first[name] for name in ("first_scored", "read_from")}
    runs = {row["judgement_no"]: row["run_id"] for row in judgements}
    return versions[first["version_id"]] | edges | {"until": judgements[-1]["last_time"], "runs": runs}


def _count(state: State, reader: Reader, group: Sequence[Row]) -> None:
    steps = explaining_steps(setting_of(group[0]), reader.kind)
    until = [row["until"] for row in group]
    earliest = min(row["read_from"] for row in group)
    with Running(state.session, steps, state.tables.nodes()) as running:
        running.load("cohort", cohort_of(group, read_until=until, planned_from=0))
        rows = reader.readings(assets_of(group), earliest, max(until))
        running.put("identified", identified(running, rows))
        visits, moves = running.rows("banded"), running.rows("move_counts")
    band_visits, moved = [], []
    for channel in group:
        version, runs = channel["version_id"], list(channel["runs"].items())
        mine = [row for row in visits if row["version_id"] == version]
        if sum(row["visits"] for row in mine) != len(runs) * channel["window_length"]:
            # Rows went, or came late, since it was scored: it is asked for no more.
            nothing = {"version_id": version, "band": -1, "visits": 0, "novel": 0}
            mine = [{**nothing, "window_no": number} for number in range(len(runs))]
        else:
            moved += [_of_run(row, runs) for row in moves if row["version_id"] == version]
        band_visits += [_of_run(row, runs) for row in mine]
    # Bands come last: a judgement that has none is counted again.
    if moved:
        state.append_rows("move", moved)
    state.append_rows("band_visit", band_visits)


def _of_run(row: Row, runs: Sequence[tuple[int, int]]) -> Row:
    """Return the counts of a window as those of its judgement, for the run that wrote it."""
    number, run = runs[row["window_no"]]
    counted = {name: value for name, value in row.items() if name != "window_no"}
    return {**counted, "judgement_no": number, "run_id": run}
