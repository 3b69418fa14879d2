"""Files of ``sql/report`` one at a time, over a few rows of signals that stand beside others."""

from by_hand import rows, step


def test_episodes_are_told_but_those_that_are_a_part_of_another() -> None:
    names = (
        "monitor status episode_id asset channel is_proving label note since_tick first_tick last_tick "
        "evidence height"
    )
    said = [(1, "open", 50), (2, "closed", 90), (3, "merged", 95), (4, "closed", 70), (5, "open", 60)]
    alarms = [
        ("gam", status, number, "a", "x", 0, None, None, since, 1, 2, 3, 4)
        for number, status, since in said
    ]
    found = step(
        "report/alarms", {"monitor": "gam"}, stored_alarm=rows(names, *alarms, ("b", *alarms[0][1:]))
    )
    assert [row[0] for row in found] == [5, 1, 2, 4], "open ones first, each kind from the latest on"


def test_blocks_and_healthy_cells_are_those_of_one_signal() -> None:
    kept = [(7, 3, 1), (7, 3, 0), (7, 2, 2), (7, 4, 3), (8, 3, 4)]
    blocks = rows(
        "support_id channel_id block first_time last_time vectors novel",
        *((*one, 10, 20, 5, 0) for one in kept),
    )
    found = step("report/blocks", {"support_id": 7, "channel_id": 3}, stored_block=blocks)
    assert [row[0] for row in found] == [0, 1]
    cells = rows("support_id cell_key", (6, 1), (7, 2), (7, 3), (8, 4))
    assert step("report/healthy_keys", {"support_id": 7}, stored_support=cells) == [(2,), (3,)]


READINGS = [
    (1, 10, 5.0),
    (1, 14, -2.0),
    (1, 15, 9.0),
    (1, 19, 1.0),
    (1, 20, None),
    (1, 21, 3.0),
    (2, 12, 99.0),
]


def test_an_envelope_holds_the_lowest_and_the_highest_of_a_stretch() -> None:
    found = step(
        "report/envelope",
        samples=rows("channel_id time value", *READINGS),
        channels=rows("channel_id asset channel", (1, "a", "x"), (2, "b", "x")),
        wanted=rows("number asset channel first_tick stretch_length", (0, "a", "x", 14, 5.0)),
    )
    assert found == [(0, 0, -2.0, 9.0), (0, 1, 1.0, 3.0)]


def test_a_piece_holds_the_readings_that_lie_next_to_its_instant() -> None:
    found = step(
        "report/pieces",
        {"most": 3, "programs": [], "carried": []},
        samples=rows("channel_id time value", *READINGS),
        channels=rows("channel_id asset channel", (1, "a", "x"), (2, "b", "x")),
        wanted_pieces=rows(
            "number asset channel piece about_tick last_tick",
            (0, "a", "x", "onset", 16, 99),
            (0, "a", "x", "healthy", 21, 19),
        ),
    )
    assert found == [
        *((0, "healthy", 14, -2.0), (0, "healthy", 15, 9.0), (0, "healthy", 19, 1.0)),
        *((0, "onset", 14, -2.0), (0, "onset", 15, 9.0), (0, "onset", 19, 1.0)),
    ]
