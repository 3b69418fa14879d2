"""What commands say first of pools: how many channels taught nothing, and by whom they are judged."""

from collections.abc import Sequence

from gam_db.checking.words import number_of
from gam_db.cli import page
from gam_db.cli.render import WORDS
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import pattern_matches


def lines(rows: Sequence[Row], calibration: Calibration) -> list[str]:
    """Return a line for channels that nobody vouches for, and one for those that others judge.

    Args:
        rows: of channels, with asset, vouched_by and taught_by (see :func:`gam_db.support`).
        calibration: under which they were calibrated.
    """
    texts, sentences = WORDS["pools"], []
    teachers = calibration.teachers if calibration.pool is not None else ()
    assets = {row["asset"] for row in rows}
    if teachers and not any(pattern_matches(teacher, asset) for teacher in teachers for asset in assets):
        sentences.append(texts["nobody"].format(teachers=page.some(list(map(printable, teachers)))))
    for words, is_alone in (("not_watched", True), ("judged", False)):
        vouched = [row for row in rows if row["vouched_by"] and (row["vouched_by"] == 1) == is_alone]
        if vouched:
            by = page.some(sorted({printable(row["taught_by"]) for row in vouched}), 3)
            all_of_them = number_of(len(rows), "channel")
            sentences.append(texts[words].format(count=len(vouched), all=all_of_them, teachers=by))
    return sentences
