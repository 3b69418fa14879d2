"""Status: the stored status of every channel, without reading the source.

This module owns the table that ``gam status`` prints. The view ``gam_fleet`` decides what needs
attention, :mod:`gam_db.findings` words the reasons, and :mod:`gam_db.stored.problems` data problems.
"""

import datetime as dt
import html
import itertools
from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from gam_db.clock import FAR_AHEAD, JUMP, LONG_AGO, Length, TimeKind, shown_instant
from gam_db.columns import COUNT, SHARE, TRUTH, WORD, columns
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.template import text
from gam_db.findings import ORDER, Course, Row, finding, shortcomings, standing
from gam_db.method.adding import add
from gam_db.settings.parameters import pattern_matches
from gam_db.stored import lengths
from gam_db.stored.checking.proving import STATE, Proof, last_proofs
from gam_db.stored.problems import data_problems, jumped, left_out, programs
from gam_db.stored.schema import migrations
from gam_db.stored.state import State, kind_of
from gam_db.units import time_type

#: Newest buckets of a channel in which a jump of its counter is looked for.
_ENDS = 64


class Standing(NamedTuple):
    """How a monitor is: what :func:`status` returns, and its data problems apart from that."""

    channels: pa.Table
    problems: pa.Table

    @property
    def watched(self) -> int:
        """How many channels are watched (``sql/stored/state/watched.sql``)."""
        return int(pc.sum(self.channels["watched"]).as_py() or 0)

    def of_assets(self, pattern: str) -> "Standing":
        """Return the same for some assets, with the problems of the monitor as a whole."""
        channels, problems = (
            table.filter(
                pa.array([name is None or pattern_matches(pattern, name) for name in names], pa.bool_())
            )
            for table in self
            for names in [table["asset"].to_pylist()]
        )
        return Standing(channels, problems)


def status(
    state: State,
    monitor: str = "default",
    park_after: Length | Literal[False] | None = None,
    now: int | None = None,
) -> pa.Table:
    """Return the stored status of each channel of a monitor, the most urgent first.

    A row is one channel under its active version:

    * ``asset``, ``channel``, ``version``: its names, and which calibration it is (1, 2, ...)
    * ``status``: proving or open (as its episode is), high (its indicator opened the episode, as its
      judgements have no limit), labelled (that episode is a false alarm or a new program), setup (the
      calibration is not good enough to be watched, or unrepresentative), waiting (less than a window is
      scored), blind (below its limit, but no shift of its machine would show), ok, standing (it would be
      one of these three, and the signal stands still) or not assessed (constant in calibration, or
      without one: never an alarm);
      ``needs_attention``: setup, or an episode of it asks for it
    * ``verdict``, ``floor``: of the certificate; ``hi_limit``, NULL where the verdict is neither ready
      nor blind;
      ``limit_reason``: why nothing judges the channel
    * ``hi``: the latest health indicator, ``novel_in_window`` / ``window``; NULL before a full window
    * ``sees``: the smallest shift, in percent of its usual range, that its indicator would show both
      ways, if the machine works as in calibration; ``sees_half_stroke``, ``sees_frozen``,
      ``sees_faster`` (3/2), ``sees_slower`` (2/3): 1, 0, or NULL where it could not be tried;
      ``would_not_see``: what of these it would not, in words; ``blind_reason``: range, blocks, cells or
      delay where the verdict is blind
    * ``vouched_by``, ``taught_by``, ``member_floor``: of a pool, as :func:`gam_db.support` has them
    * ``bins``: per axis of its grid, as found where they were left to be
    * ``trend``: ``hi`` less the one a window earlier, (``novel_in_window`` - ``novel_window_before``) /
      ``window``, so that no vector is in both; NULL until two windows are scored
    * ``course``: the indicator of late, oldest first, in at most 64 stretches of buckets that hold 64
      buckets or 8 windows, whichever is more; the highest of each; NULL until a window is scored;
      ``course_from``: when it begins
    * ``scored``: vectors in full buckets; ``last_time``: when the last of them ends
    * ``watched``: its calibration lets it be judged, rows of it were read, it is not silent, and the
      monitor as a whole still gets data (``sql/stored/state/watched.sql``)
    * ``last_data``: how far its newest run that read anything read; ``silent``: that is more than
      ``park_after`` behind the newest of the whole monitor, which is never later than now, or no run has
      found any yet; ``looked_at``: when the last run looked (UTC)
    * ``still_since``: since when the signal stands still (``still_after``), as far as it is scored; NULL
      where it moves
    * ``differing_contexts``: runs that found other samples than were scored, since rows came later than
      lookback allows or were taken away; ``repair_from``: scoring again from there mends it
    * ``calibration_rows``: different readings inside calibration when it was learnt (one that comes
      again unchanged counts once); ``calibration_rows_added``: how many more there are since (less than
      0: fewer); NULL if they were not counted again
    * ``judged_by``: episode, where calibration gave a limit of judgements, else indicator; NULL where
      nothing judges it; ``episode``: its open one, or that which asks; ``asking``: how many do;
      ``onset``: since when it is proving, open or high; NULL where it is none of these; ``label``: what
      people said last of that episode
    * ``is_far_above``: 1 where ``hi`` is at ten times ``hi_limit`` or more, whatever the status, else 0;
      ``strength``: of what is above, the highest evidence over the height, or ``hi`` / ``hi_limit``
    * ``settings_hash``, ``method_hash``: what the version was made under
    * ``remarks``: what is to be known, in plain words; what is wrong with data is in
      :meth:`gam_db.Monitor.data_problems`

    Times are timestamps as in the source, or integers where it counts.

    Args:
        state: the state tables; they are only read.
        monitor: its name.
        park_after: how far a channel may lag behind the others before it is called silent; False for
            ever. Default one day, for counters for ever.
        now: this instant, in microseconds since 1970 (UTC); default by the clock of this machine.

    Raises:
        StateError: there is no state of this gam-db.
        ConfigurationError: there is no such monitor.
        ParameterError: ``park_after`` is no length of time of this monitor.
    """
    return assessed(state, monitor, park_after, now).channels


def assessed(
    state: State,
    monitor: str = "default",
    park_after: Length | Literal[False] | None = None,
    now: int | None = None,
    shown_in: dt.tzinfo = dt.UTC,
) -> Standing:
    """Return how a monitor is; see :func:`status`.

    Args:
        state: as given there.
        monitor: likewise.
        park_after: likewise.
        now: likewise.
        shown_in: the time zone of the sentences of data problems.
    """
    migrations.require(state.session, state.tables)
    monitor_row = state.monitor(monitor)
    kind = kind_of(monitor_row)
    stored = state.fetch("stored/state/status_rows", {"monitor": text(monitor), "long_ago": LONG_AGO})
    instant = state.session.now() if now is None else now
    steps = _watching(kind, lengths.park_after(park_after, kind), instant)
    with state.session.lent(stored) as lent:
        courses = _courses(state.fetch("stored/state/course", tables={"status_rows": lent}))
        tables = {**state.tables.nodes(), "status_rows": lent}
        ends = {row["version_id"]: row for row in state.session.rows(steps.query("watched", tables))}
        problems = state.session.rows(steps.query("data_problems", tables))
        # A calendar has pauses, and a clock that tells what is ahead.
        jumps = state.session.rows(steps.query("jumps", tables)) if kind.is_counter else []
    met = state.rows("stored/state/left_out_rows", {"monitor_id": monitor_row["monitor_id"]})
    ran = state.rows("stored/state/program_problems", {"monitor": text(monitor)})
    rows = stored.sort_by(list(ORDER)).to_pylist()
    finding_rows, about = [], {}
    for row in rows:
        end = ends[row["version_id"]]
        row |= {"last_data": end["last_data"], "silent": bool(end["is_silent"])}
        row["watched"] = bool(end["is_watched"])
        span, course = (row["m"] - 1) * row["tau"], _course(row, courses.get(row["version_id"]))
        finding_row = finding(row, span, row["window_length"], course)
        remarks = [*finding_row["remarks"], *_remarks(row, kind)]
        lacking = shortcomings(row, span) if row["verdict"] == "no_data" else []
        about[row["version_id"]] = {name: row[name] for name in ("asset", "channel", "version")}
        about[row["version_id"]]["why"] = "".join(lacking)
        finding_rows.append(
            {**finding_row, "remarks": [remark for remark in remarks if remark not in lacking]}
        )
    nobody = dict.fromkeys(("asset", "channel", "version", "why"))
    listed = [row | about.get(row["version_id"], nobody) for row in problems]
    listed += [*left_out(met, len(rows)), *jumped(jumps), *programs(ran)]
    return Standing(_table(finding_rows, kind), data_problems(listed, kind, shown_in))


def _watching(kind: TimeKind, longest: int | None, now: int) -> Pipeline:
    """Return the steps over *status_rows* up to *watched* and *data_problems*."""
    steps = Pipeline(small=frozenset(("last_data", "watched")))
    slots = {
        "now": FAR_AHEAD if kind.is_counter else now,
        "has_clock": 0 if kind.is_counter else 1,
        "park_after": FAR_AHEAD if longest is None else longest,
    }
    add(steps, "stored/state/last_data")
    add(steps, "stored/state/watched", slots)
    add(steps, "stored/state/differing_contexts")
    add(steps, "stored/state/data_problems")
    add(steps, "stored/state/bucket_ends", {"newest": _ENDS})
    add(steps, "health/jumps", {"jump": JUMP})
    return steps


def as_html(rows: pa.Table) -> str:
    """Return the main columns of a status as a table for a notebook; all names are escaped."""
    names = ("asset", "channel", "status", "hi", "hi_limit", "trend", "verdict", "last_data")
    head = "".join(f"<th>{name}</th>" for name in names)
    body = "".join(
        f"<tr>{''.join(f'<td>{_cell(row[name])}</td>' for name in names)}</tr>"
        for row in map(_remarked, rows.to_pylist())
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _remarked(row: Row) -> Row:
    """Return a row whose status includes its label, or that it is far above its limit."""
    far = "far above" if row["is_far_above"] and row["onset"] is None else None
    return row | {"status": ", ".join(filter(None, (row["status"], row["label"], far)))}


def proved(state: State, monitor: str = "default") -> Proof | None:
    """Return when the state of a monitor was last compared with its source; None if it never was.

    Raises:
        StateError: there is no state of this gam-db.
        ConfigurationError: there is no such monitor.
    """
    migrations.require(state.session, state.tables)
    return last_proofs(state, state.monitor(monitor)["monitor_id"]).get(STATE)


def validity(state: State, monitor: str = "default") -> Row:
    """Return how many readings the newest run held to ``valid_when``, and for how many it does not hold.

    These are ``held`` and ``invalid``; both are 0 where the source has no such condition.
    """
    rows = state.rows("stored/state/validity", {"monitor": text(monitor)})
    return rows[0] if rows else {"held": 0, "invalid": 0}


def machines(state: State, monitor: str, channels: pa.Table) -> pa.Table:
    """Return a row per machine, the most urgent first.

    Columns: ``asset``; ``since`` (when the first of its signals above went above), ``above``, of how
    many ``watched`` signals, ``not_watched`` (nothing judges them), ``channels`` (all of them);
    ``first_channel``, ``strongest_channel`` and its ``strength`` (evidence over the height, or ``hi`` /
    ``hi_limit``); ``together`` (the most that left health within one window); ``need_attention`` and
    ``silent``, how many of its signals do and are.

    Args:
        state: as in :func:`status`.
        monitor: likewise.
        channels: what :func:`status` returned, or some of its rows: only their machines are returned.
    """
    kind = kind_of(state.monitor(monitor))
    counted: dict[str, list[int]] = {}
    for row in channels.select(["asset", "needs_attention", "silent"]).to_pylist():
        of = counted.setdefault(row["asset"], [0, 0])
        of[0] += row["needs_attention"]
        of[1] += row["silent"]
    rows = [
        row | dict(zip(("need_attention", "silent"), counted[row["asset"]], strict=True))
        for row in state.rows("stored/state/machine_rows", {"monitor": text(monitor)})
        if row["asset"] in counted
    ]
    schema = columns(
        (WORD, "asset"),
        (time_type(kind), "since"),
        (COUNT, "above watched not_watched channels"),
        (WORD, "first_channel strongest_channel"),
        (SHARE, "strength"),
        (COUNT, "together need_attention silent"),
    )
    arrays = {field.name: pa.array([row[field.name] for row in rows], field.type) for field in schema}
    return pa.table(arrays, schema=schema)


def _courses(stretches: pa.Table) -> dict[int, tuple[NDArray[np.float64], int]]:
    """Cut the stretches, which come in order, into one course per version, with when it begins."""
    versions = stretches["version_id"].to_numpy()
    hi, first = stretches["hi"].to_numpy(), stretches["first_time"]
    edges = [0, *(np.flatnonzero(np.diff(versions)) + 1).tolist(), len(versions)]
    return {
        int(versions[start]): (hi[start:end], first[start].as_py())
        for start, end in itertools.pairwise(edges)
        if end > start
    }


def _course(row: Row, course: tuple[NDArray[np.float64], int] | None) -> Course | None:
    if row["bucket"] is None or course is None:
        return None
    hi, since = course
    return Course(
        hi=hi,
        since=since,
        highest=row["hi_highest"],
        vectors=(row["bucket"] + 1) * row["stride"],
        novel=row["novel_in_window"] or 0,
        out_of_range=row["out_of_range_in_window"],
        has_moved=False,  # that is a data problem
    )


def _remarks(row: Row, kind: TimeKind) -> list[str]:
    """Return what only the state can tell."""
    remarks = standing(row["still_since"], kind)
    if row["episode"] is not None:
        zone = "" if kind.is_counter else " UTC"
        onset = row["onset"]
        since = "" if onset is None else f" since {shown_instant(onset, kind)}{zone}"
        label = "" if row["label"] is None else f", labelled {row['label']}"
        remarks.append(f"episode {row['episode']}{since}{label}: gam alarm {row['episode']}")
    if row["gone_from"] is not None:
        remarks.append(
            f"rows after {shown_instant(row['gone_from'], kind)} are gone from the source, though new "
            "ones hang on them: what is stored stays, and the first samples after them are not scored"
        )
    added, then = row["calibration_rows_added"], row["calibration_rows"]
    if added and added == -then:
        end = shown_instant(row["calibration_end"], kind)
        remarks.append(f"calibration, up to {end}, is gone from the source; what it taught stays")
    elif added is not None and added < 0:  # more of them are a data problem
        remarks.append(
            f"calibration data changed: {added:+,} rows since version {row['version']} was made; gam "
            "check --state says whether they are gone from the source"
        )
    return remarks


def _table(rows: Sequence[Row], kind: TimeKind) -> pa.Table:
    """Return the findings as a table, in their order."""
    time = time_type(kind)
    schema = columns(
        (WORD, "asset channel"),
        *((COUNT, "version"), (WORD, "status"), (TRUTH, "needs_attention watched"), (WORD, "verdict")),
        *((SHARE, "floor hi_limit"), (WORD, "limit_reason"), (SHARE, "hi trend")),
        (COUNT, "sees sees_half_stroke sees_frozen sees_faster sees_slower"),
        (WORD, "would_not_see blind_reason"),
        (COUNT, "vouched_by"),
        (WORD, "taught_by"),
        (SHARE, "member_floor"),
        (COUNT, "novel_in_window novel_window_before window bins"),
        *((pa.list_(SHARE), "course"), (time, "course_from"), (COUNT, "scored")),
        *((time, "last_time last_data"), (TRUTH, "silent"), (time, "still_since")),
        *((pa.timestamp("us"), "looked_at"), (COUNT, "differing_contexts"), (time, "repair_from")),
        *((COUNT, "calibration_rows calibration_rows_added"), (WORD, "judged_by")),
        *((COUNT, "episode asking"), (time, "onset"), (WORD, "label"), (COUNT, "is_far_above")),
        *((SHARE, "strength"), (WORD, "settings_hash method_hash")),
        (pa.list_(WORD), "remarks"),
    )
    arrays = {
        field.name: pa.array([row[field.name] for row in rows], field.type, from_pandas=True)
        for field in schema
    }
    return pa.table(arrays, schema=schema)


def _cell(value: object) -> str:
    """Return a value for a cell of that table."""
    if value is None:
        return ""
    return html.escape(f"{value:.3g}" if isinstance(value, float) else str(value))
