"""Files of ``sql/`` one at a time, over a few rows: what a whole study rarely asks of them."""

import random

from sqlglot import exp

import alarms_reference as plain
from by_hand import fetched, rows, step
from gam_db.composing.pipeline import Pipeline, filled
from gam_db.composing.template import column, fill, text
from gam_db.engines import duckdb
from gam_db.method.alarms import add_replay


def test_each_cell_of_a_support_is_one_bit() -> None:
    """The first one, too, whose number is 0."""
    found = step(
        "support/support_bits",
        {"bits": duckdb.gathered(column("cell_key"), 8)},
        support=rows("support_id cell_key", (1, 0), (1, 5), (2, 0), (3, 7)),
    )
    assert found == [(1, "10000100"), (2, "10000000"), (3, "00000001")]


def test_the_census_takes_the_widest_readings_for_what_they_are() -> None:
    """1e300 is a number, what is beyond it is missing; a slice begins at its first instant."""
    readings = [
        (0, 1e300),
        (9, -1e300),
        (10, 1.1e300),
        (11, None),
        (19, float("nan")),
        (None, 1.0),
        (20, 2.0),
    ]
    found = step(
        "census/slices",
        {"origin": 0, "width": 10},
        readings=rows("asset channel time reading", *(("a", "x", *one) for one in readings)),
    )
    assert found == [
        ("a", "x", 0, 2, 0, 0, -1e300, 1e300, 0, 9),
        ("a", "x", 1, 3, 0, 3, None, None, 10, 19),
        ("a", "x", 2, 1, 0, 0, 2.0, 2.0, 20, 20),
        ("a", "x", None, 0, 1, 0, 1.0, 1.0, None, None),
    ]


def test_what_is_there_is_coded_where_a_single_sample_is_missing() -> None:
    found = step(
        "certificate/present_codes",
        {"settings_no": 0, "read": exp.column("missing_readings", table="named") > 0, "carried": []},
        samples=rows("channel_id time value", (1, 5, 0.5), (1, 6, None), (2, 5, 0.5), (3, 5, None)),
        channels=rows("channel_id missing_readings settings_no", (1, 1, 0), (2, 0, 0), (3, 1, 1)),
    )
    assert found == [(1, 5, 1), (1, 6, 0)]


def test_a_channel_is_in_order_where_each_row_is_later() -> None:
    stored: dict[str, list[int | None]] = {
        "growing": [1, 2, 5],
        "again": [1, 1],
        "back": [3, 2],
        "alone": [9],
        "without time": [3, None, 4],
    }
    listed = [(name, time) for name, times in stored.items() for time in times]
    readings = rows("asset channel time reading", *((name, "x", time, 0.0) for name, time in listed))
    proof = [exp.alias_(fill("streams/in_order"), "in_order")]
    found = {}
    for name in stored:
        names = {"asset": text(name), "channel": text("x")}
        (found[name],) = fetched(filled("streams/names", {**names, "proof": proof}), readings=readings)
    assert found == {
        "growing": (3, 0, 0, 1, 5, 1),
        "again": (2, 0, 0, 1, 1, 0),
        "back": (2, 0, 0, 2, 3, 0),
        "alone": (1, 0, 0, 9, 9, 1),
        "without time": (2, 1, 0, 3, 4, 0),
    }


def channel(chance: random.Random, blocks: int) -> list[int]:
    """Return roots of blocks, with stretches that are raised."""
    answer, raised = [], 0
    for _ in range(blocks):
        raised = (
            chance.randrange(300, 1200) if chance.random() < 0.1 else raised * (chance.random() < 0.8)
        )
        answer.append(600 + chance.randrange(400) + raised)
    return answer


def test_blocks_of_calibration_are_judged_without_those_near_them() -> None:
    """Section 3 of alarms: of two families, the roots of each block, and the episodes by height."""
    chance = random.Random(3)
    families = {0: [(1, 4), (2, 4), (3, 4)], 1: [(4, 25), (5, 4)]}
    roots = {number: channel(chance, 90) for of in families.values() for number, _ in of}
    members = [(number, family, g) for family, of in families.items() for number, g in of]
    steps = Pipeline()
    add_replay(steps)
    heights = range(4, 60, 5)
    tables = {
        "members": rows("channel_id family_no g", *members),
        "heights": rows("quarters", *((h4,) for h4 in heights)),
        "block_roots": rows(
            "channel_id g block root",
            *(
                (number, g, block, x)
                for number, _, g in members
                for block, x in enumerate(roots[number])
            ),
        ),
        "spreads": rows(
            "channel_id g blocks least total squares", *(spread(n, g, roots[n]) for n, _, g in members)
        ),
    }
    again = {number: plain.replayed(roots[number], g) for number, _, g in members}
    left_out = fetched(steps.query("left_out"), **tables)
    assert {(row[0], row[2]): row[-1] for row in left_out} == {
        (number, block): root for number, found in again.items() for block, root in enumerate(found)
    }
    expected = []
    for family, of in families.items():
        for h4 in heights:
            height = 250 * h4
            cap = (height + 1) // 2
            said = [plain.episodes_of(plain.judged(again[n], 1000, height, cap)) for n, _ in of]
            expected += [(family, h4, episodes)] if (episodes := sum(map(len, said))) else []
    assert fetched(steps.query("counted_replay"), **tables) == expected
    assert len({episodes for *_, episodes in expected}) > 3


def spread(number: int, g: int, roots: list[int]) -> tuple[int, ...]:
    above = [root - min(roots) for root in roots]
    return (number, g, len(roots), min(roots), sum(above), sum(one * one for one in above))


def test_a_judgement_that_is_known_tells_when_evidence_last_began() -> None:
    """Section 4: what is known stands for all before it, be it that evidence never was 0."""
    names = "channel_id limit_no judgement_no root reference height prior_open prior_zero evidence "
    names += "judged_from"
    after = [(1500, -1, None, 400), (1500, -1, None, 900)]
    found = step(
        "alarms/opened",
        evidence=rows(
            names,
            *(
                (1, 0, n, root, 1000, 900, *rest, 0)
                for n, (root, *rest) in enumerate([(1500, 0, 7, 10), *after])
            ),
            *(
                (2, 0, n, root, 1000, 900, *rest, 0)
                for n, (root, *rest) in enumerate([(1500, 1, None, 10), *after])
            ),
            *(
                (3, 0, n, root, 1000, 900, *rest, 0)
                for n, (root, *rest) in enumerate([(900, -1, None, 0), *after])
            ),
            *(
                (4, 0, n, root, 1000, 900, *rest, 1)
                for n, (root, *rest) in enumerate([(1500, 0, None, 10), *after])
            ),
        ),
    )
    # channel, judgement, is_open, last_zero
    assert [(row[0], row[2], *row[-2:]) for row in found] == [
        *((1, 0, 0, 7), (1, 1, 0, 7), (1, 2, 1, 7)),
        *((2, 0, 1, None), (2, 1, 1, 0), (2, 2, 1, 1)),  # no onset lies before what is open
        *((3, 0, 0, 0), (3, 1, 0, 0), (3, 2, 1, 0)),
        *((4, 0, 0, None), (4, 1, 0, 0), (4, 2, 1, 0)),  # nor before a new limit
    ]
