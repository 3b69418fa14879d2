"""Judgements, their limits and episodes (alarms, sections 2 to 4)."""

from collections.abc import Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled
from gam_db.method.adding import OfSet, add, add_stacked, join_sets
from gam_db.method.resolved import Method
from gam_db.method.source import by_override, named_like
from gam_db.settings.source import TimeNode

#: Beyond how many blocks another one vouches for a cell: usually, for the order ratio, under drift.
NEAR, ORDERED, FAR = 1, 4, 8

_SMALL = (
    *("buffered", "block_roots", "spreads", "exclusive_cells", "order_ratios", "lengths"),
    *("judged_windows", "opened", "merged"),
)

#: The number of the parameters that a channel has.
_SETTINGS_NO = exp.column("settings_no")


def add_learnt_limits(steps: Pipeline, method: Method, families: Sequence[str]) -> None:
    """Add the statistics of calibration for the judgements of each channel, up to *learnt_limits*.

    Families are patterns of channel names. Bins that were found make no family.
    """
    join_sets(steps, method, ("visits", "block_sizes"))
    add_counted(steps, method.has_instants)
    others: exp.Expr = _SETTINGS_NO
    if method.requested is not None:
        variants = list(dict.fromkeys(method.requested.variants()))
        others = by_override(method.requested, variants.index)
    add_spreads(steps, families, others=others)


def add_counted(steps: Pipeline, has_instants: bool = True, bounds: str = "bounds") -> None:
    """Add the counts of calibration: *buffered*, *bands*, *order_ratios* and *lengths*.

    Where calibration may be single instants (``has_instants``), the samples are read for them.
    """
    steps.small |= {"visits", "block_sizes", "vouched", "banded", "exclusive_cells", "chances"}
    band = band_of(exp.column("cell_key", table="visit"), exp.column("bins", table="scale"))
    add(steps, "alarms/vouched", {"band": band, "far": FAR}, tables={"bounds": bounds})
    add(steps, "alarms/banded", {"band": band}, tables={"bounds": bounds})
    add_stacked(steps, "alarms/buffered", [{"g": g} for g in (NEAR, ORDERED, FAR)])
    add_stacked(steps, "alarms/bands", [{"g": g} for g in (NEAR, FAR)])
    add(steps, "alarms/exclusive_cells")
    add(steps, "alarms/chances", _chances(2 * ORDERED + 1))
    add(steps, "alarms/order_ratios", {"g": ORDERED})
    add(steps, "alarms/declared_lengths", name=None if has_instants else "lengths")
    if has_instants:
        add(steps, "alarms/lengths")


def band_of(key: exp.Expr, bins: exp.Expr) -> exp.Expr:
    """Return the band of a cell by its newest coordinate (``sql/alarms/band.sql``)."""
    return template.fill("alarms/band", {"key": key, "bins": bins})


def add_spreads(
    steps: Pipeline,
    families: Sequence[str],
    learnt_step: str | None = None,
    others: exp.Expr = _SETTINGS_NO,
) -> None:
    """Add the spreads of *buffered*; the last step is *learnt_limits*.

    Families are patterns of channel names; others is the number of a channel's family that none of them
    names. The step ``learnt_step`` has a row per channel with all else that calibration says; without
    one, that is said by the steps of a study.
    """
    steps.small |= set(_SMALL)
    reads = ("channels", "limited", "bounds", "order_ratios", "lengths", "block_sizes")
    tables = {} if learnt_step is None else dict.fromkeys(reads, learnt_step)
    add(steps, "alarms/block_roots", {"root": root_of("novel")}, tables=tables)
    add(steps, "alarms/spreads", _figures())
    rows = exp.union(*(_learnt(g, families, others) for g in (NEAR, FAR)), distinct=False)
    steps.add("learnt_limits", rows, template.load("alarms/learnt_limits").comment, tables)


def add_replay(steps: Pipeline) -> None:
    """Add the replay of calibration, over the steps *members* and *heights*.

    The last steps are *left_out*, a row per block, and *counted_replay*, a row per family and height.
    """
    add(steps, "alarms/left_out", _figures())
    steps.small |= {"left_out"}
    add(steps, "alarms/replay")
    _add_episodes(steps, "replay", "_replay")
    add(steps, "alarms/counted_replay")


def add_judgements(steps: Pipeline, method: Method, instant_of: TimeNode) -> None:
    """Add the judgements over *frozen_limits*; the last steps are *judgements* and *episodes*."""
    for number in range(len(method.settings)):
        OfSet(steps, method, number).add("alarms/judged_windows")
    join_sets(steps, method, ("judged_windows",))
    add_judged(steps, instant_of)


def add_judged(steps: Pipeline, instant_of: TimeNode) -> None:
    """Add the judgements over *judged_windows* and *frozen_limits*, likewise."""
    add(steps, "alarms/rooted", {"root": root_of("novel", "judged")})
    _add_episodes(steps, "rooted", "")
    edges = {name: instant_of(exp.column(name, table="counted")) for name in ("first_time", "last_time")}
    add(steps, "alarms/judgements", edges)
    times = {
        "onset_time": instant_of(exp.column("first_time", table="beginning")),
        "first_time": instant_of(exp.column("first_time", table="opening")),
        "last_time": instant_of(exp.column("last_time", table="closing")),
    }
    add(steps, "alarms/episodes", times)


def add_stored_judgements(steps: Pipeline, buckets: int, near: exp.Expr) -> None:
    """Add judgements over *judged_buckets* and *limit_spans* of a state, up to *opened*.

    Near is a condition on *bucket* that holds for the judgements before; a window has so many buckets.
    """
    slots: dict[str, template.Slot] = {"buckets": buckets}
    add(steps, "alarms/judged_windows", slots, tables={"bucket_counts": "judged_buckets"})
    add(steps, "stored/alarms/judged_with_limits", {"root": root_of("novel", "judged"), "near": near})
    for name in ("evidence", "opened"):
        add(steps, f"alarms/{name}", tables={"rooted": "judged_with_limits"})


def add_backtested(steps: Pipeline, healthy: Sequence[tuple[int, int]]) -> None:
    """Add what limits raise in closed intervals of time (none: always), after :func:`add_judgements`."""
    spans = [{"time_from": start, "time_to": end} for start, end in healthy]
    inside = [template.fill("alarms/within", span) for span in spans]
    add(steps, "alarms/backtested", {"healthy": exp.or_(*inside) if inside else exp.true()})


def _add_episodes(steps: Pipeline, rooted: str, suffix: str) -> None:
    """Add evidence, open judgements, and their episodes."""
    names = {"rooted": rooted, **{name: f"{name}{suffix}" for name in ("evidence", "opened")}}
    for name in ("evidence", "opened", "merged"):
        add(steps, f"alarms/{name}", name=f"{name}{suffix}", tables=names)


def _figures() -> dict[str, template.Slot]:
    least, total, squares, blocks = map(exp.column, ("least", "total", "squares", "blocks"))
    centre = {"least": least, "total": total, "blocks": blocks}
    spread = {"total": total, "squares": squares, "blocks": blocks}
    return {
        "centre": template.fill("alarms/centre", centre),
        "spread": template.fill("alarms/spread", spread),
    }


def root_of(column: str, table: str | None = None) -> exp.Expr:
    """Return the root of a count (``sql/alarms/root.sql``)."""
    return template.fill("alarms/root", {"count": exp.column(column, table=table)})


def _chances(most: int) -> dict[str, template.Slot]:
    """Return the slots of *chances*: cells of so many blocks at most."""
    product: exp.Expr = exp.cast(exp.Literal.number(1), "DOUBLE")
    products = exp.Case()
    for blocks in range(1, most + 1):
        products = products.when(exp.column("visited_blocks").eq(blocks), product)
        factor = exp.paren(template.fill("alarms/chance_factor", {"i": blocks - 1}))
        product = exp.Mul(this=product.copy(), expression=factor)
    return {"g": ORDERED, "most": most, "product": products}


def _learnt(g: int, families: Sequence[str], number: exp.Expr) -> exp.Query:
    others = exp.Add(this=number.copy(), expression=exp.Literal.number(len(families)))
    branches = ((named_like("channel", pattern) or exp.true(), n) for n, pattern in enumerate(families))
    family = template.case(branches, others)
    for column in family.find_all(exp.Column):
        column.set("table", exp.to_identifier("named"))
    return filled("alarms/learnt_limits", {"g": g, "family_no": family})
