"""``gam status``: the status of every channel and machine, and problems of the data."""

import datetime as dt
from collections.abc import Iterator, Sequence

import pyarrow as pa
import pyarrow.compute as pc

from gam_db.checking.words import number_of, percent
from gam_db.cli import machines as of_machines
from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.job import heading, place
from gam_db.cli.options import option
from gam_db.cli.render import WORDS, Page, Section, show, time_text
from gam_db.clock import TimeKind, instant, shown_instant, shown_length, zone
from gam_db.errors import ConfigurationError
from gam_db.findings import Row, need_attention
from gam_db.stored import status as stored_status
from gam_db.stored.checking.proving import Proof
from gam_db.stored.state import State


@options.of_state(*options.STATE, "park_after", *options.PAGE, "time_zone")
def status(
    settings: Settings, common: options.Common, asset: str | None = option("status.asset")
) -> None:
    """Show the status of every signal and machine.

    It reads the state in the database, not the source. Without --all it prints the 20 most urgent
    machines. A channel needs attention (exit code 2) if one of its episodes does (`gam alarms`), or,
    without a limit for judgements (`gam limits`), if its indicator is above its limit; or if its
    calibration is not good enough. Otherwise exit code 4 means that the data has a problem to fix, or
    that no channel is watched.
    """
    name, silence, shown_in = settings.monitor.name, settings.monitor.park_after, zone(common.time_zone)
    with options.opened(settings, writable=False) as session:
        state = State(session, settings.monitor.tables)
        seen = stored_status.assessed(state, name, silence, shown_in=shown_in)
        proof = stored_status.proved(state, name)
        held = stored_status.validity(state, name)
        all_machines = stored_status.machines(state, name, seen.channels)
    if asset is not None:
        seen = seen.of_assets(asset)
        if not seen.channels.num_rows:
            raise ConfigurationError(f"No asset of this monitor is called like {asset!r}.")
    channels, problems = seen
    proved = None
    if proof is not None:
        proved = vars(proof) | {"proved_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP)}
        del proved["extent"]
    urgent = need_attention(channels.to_pylist())
    machines = all_machines.filter(pc.is_in(all_machines["asset"], pc.unique(channels["asset"])))
    figures = {
        **place(settings),
        "proved": proved,
        "channels": channels,
        "machines": machines,
        **raised(channels),
        "valid_when": held,
        **both_lists(channels, problems),
    }

    def sections() -> Iterator[Section]:
        rows, everything = channels.to_pylist(), common.everything
        newest = time_text(pc.max(channels["last_data"]).as_py(), shown_in, named=True)
        counted = f"{watched(channels)} watched, of {number_of(len(machines), 'asset')}"
        yield f"{heading(settings)}: {counted}, newest data {newest}"
        yield _proof(proof, dt.datetime.now(dt.UTC))
        yield from validity(held)
        if rows:
            yield ""
            yield from page.channels(common.of(rows), "last_data", "of late", shown_in, everything)
            yield from page.cut(rows, everything, page.counted)
            yield ""
            if len(machines) > 1:
                yield from of_machines.lines(machines.to_pylist(), shown_in, everything)
        yield from page.problems(problems, everything)
        if rows:
            yield from _summary(channels, rows)

    show(Page(figures, sections(), urgent, lacking=problems.num_rows > 0), common)


def _proof(proof: Proof | None, now: dt.datetime) -> str:
    if proof is None:
        return "the state was never compared with its source; run gam check --state"
    age = instant(now, TimeKind.TIMESTAMP, "now") - proof.proved_at
    ago = shown_length(age, TimeKind.TIMESTAMP)
    outcome = (
        f"{proof.differences:,} differences"
        if proof.differences
        else "no difference, as far as its rows were still there"
    )
    return f"the state was last compared with its source {ago} ago: {outcome} (gam check --state)"


def _summary(channels: pa.Table, rows: Sequence[Row]) -> Iterator[str]:
    yield f"channels: {page.counted(rows)}"
    yield from of_machines.far_above(rows)
    yield from page.unseen(rows)
    if fewer := pc.sum(pc.less(channels["calibration_rows_added"], 0)).as_py():
        yield f"{number_of(fewer, 'channel')} with fewer rows of calibration in the source than learnt"
    yield from judging(channels)


def watched(channels: pa.Table) -> str:
    """Return how many channels are watched, of how many: 21 of 75."""
    return f"{pc.sum(channels['watched']).as_py() or 0:,} of {number_of(len(channels), 'channel')}"


def both_lists(channels: pa.Table, problems: pa.Table) -> Row:
    """Return figures of a monitor: channels that need attention, and data problems."""
    names = [
        "asset",
        "channel",
        "status",
        "hi",
        "hi_limit",
        "episode",
        "onset",
        "label",
        "is_far_above",
        "limit_reason",
        "remarks",
    ]
    urgent = channels.filter(channels["needs_attention"])
    return {
        "watched": pc.sum(channels["watched"]).as_py() or 0,
        "needs_attention": len(urgent) > 0,
        "attention": urgent.select(names),
        "data_problems": problems,
    }


def raised(status: pa.Table) -> Row:
    """Return how many channels are judged by episodes, and the episodes that ask for attention."""
    rows = status.select(["judged_by", "asking", "episode"]).to_pylist()
    return {
        "judged_by_episode": sum(row["judged_by"] == "episode" for row in rows),
        "episodes": [row["episode"] for row in rows if row["asking"]],
    }


def validity(held: Row) -> Iterator[str]:
    """Yield the share of invalid readings, where a condition tells which are valid."""
    if held["held"]:
        part = percent(held["invalid"] / held["held"])
        yield WORDS["state"]["valid_when"].format(share=part, held=number_of(held["held"], "reading"))


def judging(status: pa.Table) -> Iterator[str]:
    """Yield how channels are judged, and how many episodes need a look."""
    by_episode = raised(status)["judged_by_episode"]
    if by_episode == len(status) - status["judged_by"].null_count > 0:
        yield "judged by episodes (gam limits)"
    elif by_episode:
        yield WORDS["state"]["mixed"].format(count=number_of(by_episode, "channel"))
    elif len(status) > status["judged_by"].null_count:
        yield "judged by the health indicator and its limit (gam limits)"
    if asking := pc.sum(status["asking"]).as_py():
        yield f"{number_of(asking, 'episode')} to look at (gam alarms)"
