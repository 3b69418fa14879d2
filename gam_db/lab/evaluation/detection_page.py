"""The sections of ``gam evaluate --labels``: a line per machine, and what the figures rest on."""

from collections.abc import Iterator, Sequence

from gam_db.checking.words import number_of, spoken
from gam_db.cli import options, page
from gam_db.cli.render import Section, Table
from gam_db.clock import TimeKind
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.lab.evaluation.detection import Detection


def sections(health: str, detection: Detection, everything: bool) -> Iterator[Section]:
    """Yield the sections; with ``everything`` also a line for each channel."""
    kind = TimeKind.COUNTER if detection.unit == "steps" else TimeKind.TIMESTAMP
    rates = detection.rates.to_pylist()
    machines = [row for row in rates if row["asset"] is not None and row["channel"] is None]
    channels = [row for row in rates if row["channel"] is not None]
    total = next(row for row in rates if row["asset"] is None)
    yield (
        f"{printable(health)}: {number_of(len(channels), 'channel')} of "
        f"{number_of(len(machines), 'machine')}; {number_of(total['labels'], 'label')}"
    )
    yield ""
    lines = list(_lines(rates if everything else [*machines[: options.SHOWN], total], kind))
    yield Table("detections", lines)
    yield from page.cut(machines, everything, what=" machines")
    yield ""
    yield from _remarks(detection, total)


def _lines(rows: Sequence[Row], kind: TimeKind) -> Iterator[Row]:
    for row in rows:
        name = "all machines" if row["asset"] is None else printable(row["asset"])
        if row["channel"] is not None:
            name = f"  {printable(row['channel'])}"
        yield {**row, "name": name, "lead_text": _lead(row["lead_time"], kind)}


def _lead(lead: int | None, kind: TimeKind) -> str | None:
    """Return a lead in its unit; a delay has a minus."""
    if lead is None:
        return None
    return f"{'-' * (lead < 0)}{spoken(abs(lead), kind)}" if lead else "0"


def _remarks(detection: Detection, total: Row) -> Iterator[str]:
    """Yield what a reader must know about the figures."""
    without_value = len(
        {
            (row["asset"], row["event"], row["starts_at"], row["ends_at"])
            for row in detection.labels.to_pylist()
            if row["channel"] is None and not row["has_values"]
        }
    )
    if without_value:
        yield (
            f"labels without a value, which count neither way: {without_value:,} (before the first "
            "value, after the last, or shorter than the step between two)"
        )
    if detection.unmatched:
        yield f"labels that name no machine or signal of the indicators: {detection.unmatched:,}"
    if detection.alarms_unmatched:
        yield f"alarms that name no machine or signal of the indicators: {detection.alarms_unmatched:,}"
    if detection.without_limit:
        without = number_of(detection.without_limit, "channel")
        yield f"never raised, because they have no limit: {without}"
    if total["left_out"]:
        yield f"values in the margin of a label, which count neither way: {total['left_out']:,}"
    if not total["labelled"]:
        yield "no value is labelled"
