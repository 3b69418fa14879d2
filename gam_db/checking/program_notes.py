"""Notes on the programs of a source: how often each runs, and its readings in calibration."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

from gam_db.checking.look import Look, Row
from gam_db.checking.words import extent, number_of, percent

_APART = 10  # programs that calibration lacks, each with a sentence of its own


@dataclass(frozen=True)
class Total:
    """What a source has of one program."""

    program: str
    share: float  # of all samples
    runs: int  # of all machines
    calibration_runs: tuple[int, ...]  # of each machine
    calibration_days: tuple[int, ...]  # of each machine

    def line(self, is_counter: bool) -> str:
        """Return it in words."""
        runs, days = extent(self.calibration_runs), extent(self.calibration_days)
        held = f"{runs} run{'s' * (runs != '1')}"
        if not is_counter:
            held += f" on {days} day{'s' * (days != '1')}"
        each = " each" * (len(self.calibration_runs) > 1)
        ran = f"{percent(self.share)} of the readings in {number_of(self.runs, 'run')}"
        return f"{self.program}: {ran}; calibration: {held}{each}"


def totals(look: Look) -> list[Total]:
    """Return the programs of a source, the most frequent ones first."""
    samples = sum(row["samples"] for row in look.channels)
    assets = list(dict.fromkeys(row["asset"] for row in look.programs))
    by_program: dict[str, list[Row]] = defaultdict(list)
    for row in look.programs:
        by_program[row["program"]].append(row)
    programs = []
    for program, rows in by_program.items():
        most: dict[str, dict[str, int]] = {asset: defaultdict(int) for asset in assets}
        for row in rows:
            # Signals of one machine run the same; what one of them lacks, another may have.
            for name in ("runs", "calibration_runs", "calibration_days"):
                most[row["asset"]][name] = max(most[row["asset"]][name], row[name])
        runs, taught, days = (
            tuple(counts[name] for counts in most.values())
            for name in ("runs", "calibration_runs", "calibration_days")
        )
        share = sum(row["readings"] for row in rows) / samples
        programs.append(Total(program, share, sum(runs), taught, days))
    return sorted(programs, key=lambda total: (-total.share, total.program))


#: A subject, its words and the channels concerned.
Remark = tuple[str, dict[str, str], tuple[tuple[str, str], ...]]


def remarks(look: Look) -> Iterator[Remark]:
    """Yield the notes on the programs of a source."""
    for candidate in look.candidates:
        words = {
            "column": candidate.column,
            "programs": f"{candidate.programs:,}",
            "usual": f"{candidate.usual_run:,}",
        }
        yield "program_column", words, ()
    lacking: dict[str, list[Row]] = defaultdict(list)
    for row in look.programs:
        if not row["is_taught"] and row["later_readings"]:
            lacking[row["program"]].append(row)
    for program, rows in list(lacking.items())[:_APART]:
        count = extent([row["later_readings"] for row in rows])
        names = tuple((row["asset"], row["channel"]) for row in rows)
        yield "program_lacking", {"program": program, "count": count}, names
    if (more := len(lacking) - _APART) > 0:
        yield "programs_lacking", {"more": number_of(more, "further program")}, ()
    if look.method.programs is None:
        return
    named: dict[tuple[str, str], int] = defaultdict(int)
    for row in look.programs:
        named[row["asset"], row["channel"]] += row["readings"]
    without = {
        (row["asset"], row["channel"]): row["samples"] - named[row["asset"], row["channel"]]
        for row in look.channels
    }
    if nameless := sum(without.values()):
        share = percent(nameless / sum(row["samples"] for row in look.channels))
        yield (
            "program_unnamed",
            {"share": share, "column": look.method.programs.column},
            tuple(name for name, count in without.items() if count),
        )
