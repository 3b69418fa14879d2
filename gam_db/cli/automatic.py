"""What calibration chose by itself, in the lines of a page."""

from collections.abc import Iterator, Sequence

from gam_db.checking.words import number_of
from gam_db.cli.options import SHOWN
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.study.automatic import Siblings


def lines(siblings: Sequence[Siblings], everything: bool = False) -> Iterator[str]:
    """Yield a line for channels that share what was chosen: what, and why."""
    shown = siblings if everything else siblings[:SHOWN]
    for of in shown:
        parts = []
        if of.scores:
            parts.append(f"tau {of.tau}, {reason(of)}")
        if "window" in of.setting.open_settings:
            parts.append(f"window {of.window:,}, a twentieth of calibration")
        for m, count in sorted(of.lower.items()):
            parts.append(f"m {m} for {count:,}, because calibration is too short for m {of.setting.m}")
        if parts:
            name = printable(of.name) if of.name else "channels with a name of their own"
            yield f"chosen for {name} ({len(of.channels):,}): {'; '.join(parts)}"
    if len(shown) < len(siblings):
        yield f"... and {number_of(len(siblings) - len(shown), 'more name')}"


def reason(of: Siblings) -> str:
    """Return why a delay was chosen."""
    if of.tau == min(of.scores):
        return f"the smallest that is as good as the best: score {of.scores[of.tau]:,} of 1,000"
    smaller = max(delay for delay in of.scores if delay < of.tau)
    more = f"tau {smaller} {of.scores[smaller]:,}"
    return f"the smallest that is as good as the best: score {of.scores[of.tau]:,} of 1,000, {more}"


def reasons(of: Siblings) -> dict[str, str]:
    """Return why calibration chose what it did, by setting."""
    return {
        "m": "as given, less where calibration is too short",
        "tau": reason(of) if of.scores else "no grid passes at any delay",
        "bins": "the finest grid that is as good as the best",
        "window": "a twentieth of calibration",
    }


def scores(of: Siblings) -> str:
    """Return the score of each delay under which some grid passes."""
    text = " ".join(f"{delay}: {score:,}" for delay, score in of.scores.items())
    return text or "no grid passes at any delay"


def figures(siblings: Sequence[Siblings]) -> list[Row]:
    """Return the same for --json."""
    return [
        {
            "name": of.name or None,
            "channels": len(of.channels),
            "tau": of.tau,
            "window": of.window,
            "scores": of.scores,
            "lower": of.lower,
        }
        for of in siblings
    ]
