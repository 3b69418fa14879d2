"""Detection by its definitions, one value after another in plain Python."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from statistics import median_low


@dataclass(frozen=True)
class Interval:
    """A label or an alarm; both ends belong to it; channel None is the whole machine."""

    asset: str
    channel: str | None
    start: int
    end: int | None

    def holds(self, asset: str, channel: str | None, time: int, before: int = 0, after: int = 0) -> bool:
        """Tell whether a time of a series lies in it; a series without channel is a machine."""
        is_named = self.asset == asset and (None in (self.channel, channel) or self.channel == channel)
        return (
            is_named and self.start - before <= time and (self.end is None or time <= self.end + after)
        )


#: (asset, channel) -> its values: time, and whether it is raised.
Raised = dict[tuple[str, str | None], list[tuple[int, bool]]]


def with_machines(raised: Raised) -> Raised:
    """Return the series of channels, and those of machines: raised while a channel's last value is."""
    machines: Raised = {}
    for asset in {asset for asset, _ in raised}:
        of_machine = [values for (of, _), values in raised.items() if of == asset]
        times = sorted({time for values in of_machine for time, _ in values})
        machines[asset, None] = [
            (
                time,
                any([flag for at, flag in values if at <= time][-1:] == [True] for values in of_machine),
            )
            for time in times
        ]
    return raised | machines


def counts(
    values: Sequence[tuple[int, bool]],
    series: tuple[str, str | None],
    labels: Sequence[Interval],
    before: int,
    after: int,
) -> tuple[int, int, int, int, int]:
    """Return how many values count, are left out, raised, labelled, and both."""
    counted = left_out = raised = labelled = hits = 0
    for time, flag in values:
        is_labelled = any(label.holds(*series, time) for label in labels)
        if not is_labelled and any(label.holds(*series, time, before, after) for label in labels):
            left_out += 1
            continue
        counted += 1
        raised += flag
        labelled += is_labelled
        hits += flag and is_labelled
    return counted, left_out, raised, labelled, hits


def lead(values: Sequence[tuple[int, bool]], label: Interval) -> tuple[bool, int | None]:
    """Return whether a label holds a value, and its lead."""
    inside = [
        (at, flag) for at, flag in values if label.start <= at and (label.end is None or at <= label.end)
    ]
    if not inside:
        return False, None
    earlier = [(at, flag) for at, flag in values if at < label.start]
    since = None
    for at, flag in reversed(earlier):
        if not flag:
            break
        since = at
    if since is None:
        since = next((at for at, flag in inside if flag), None)
    start = label.start if earlier else inside[0][0]
    return True, None if since is None else start - since


def rates(figures: tuple[int, int, int, int, int]) -> tuple[Fraction | None, ...]:
    """Return F1, F1 by chance, false-alarm rate and missed-alarm rate."""
    counted, _, raised, labelled, hits = figures

    def share(part: int, of: int) -> Fraction | None:
        return Fraction(part, of) if of else None

    return (
        share(2 * hits, raised + labelled),
        share(2 * raised * labelled, counted * (raised + labelled)),
        share(raised - hits, counted - labelled),
        share(labelled - hits, labelled),
    )


def middle(leads: Sequence[int | None]) -> int | None:
    """Return the middle lead of those that there are; of two, the shorter."""
    there = [of for of in leads if of is not None]
    return median_low(there) if there else None
