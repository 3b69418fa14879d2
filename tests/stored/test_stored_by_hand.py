"""Files of ``sql/stored`` one at a time, over a few rows: what a whole history rarely asks of them."""

import pytest
from sqlglot import exp

from by_hand import rows, step
from gam_db.composing.template import Slot, column, fill

BEFORE_ALL = -(2**62)

ALWAYS = exp.true()


def test_the_last_check_of_an_extent_is_the_newest_one_that_is_not_of_tomorrow() -> None:
    proofs = rows(
        "monitor_id extent proved_at channels versions buckets differences",
        (1, "state", 10, 4, 4, 40, 0),
        (1, "state", 20, 4, 5, 60, 1),
        (1, "state", 99, 4, 5, 70, 2),
        (2, "state", 20, 9, 9, 90, 9),
        (2, "state", 30, 9, 9, 90, 9),
        (1, "source", 5, 3, 3, 30, 0),
    )
    found = step("stored/checking/last_proofs", {"monitor_id": 1, "now": 50}, stored_proof=proofs)
    assert found == [("source", 5, 3, 3, 30, 0), ("state", 20, 4, 5, 60, 1)]


def test_the_newest_run_says_when_a_version_was_read_and_any_how_far() -> None:
    """Also where the clock of an earlier one stood ahead, and where the newest read nothing."""
    runs = rows(
        "version_id run_id read_to committed calibration_readings",
        (1, 1, 50, 100, 7),
        (1, 2, 90, 300, None),
        (1, 3, None, 200, None),
        (2, 4, None, 5, None),
        (3, 5, 10, 10, 10),
    )
    active = rows("version_id", (1,), (2,))
    slots = {"long_ago": BEFORE_ALL, "since": 0}
    found = step("stored/scoring/last_reads", slots, stored_finished_run=runs, active=active)
    assert found == [(1, 90, 200, 100), (2, BEFORE_ALL, 5, BEFORE_ALL)]


#: The slots of what was read, added up.
BUCKET = "bucket_no first_time last_time context_time samples novel out_of_range"


def test_rows_that_differ_are_counted_of_both_sides() -> None:
    """Of 7, bucket 1 differs, 3 is there twice, 4 is missing; of 8 a share differs; 9 is as it is."""
    bucket_no, share = (exp.column(name) for name in ("bucket_no", "floor"))
    slots: dict[str, Slot] = {
        "owner": exp.column("version_id"),
        "among": bucket_no < 9,
        "columns": [exp.column(name) for name in ("version_id", "bucket_no", "first_time", "samples")],
        "shares": [share],
        "unlike": exp.NEQ(this=exp.Min(this=share.copy()), expression=exp.Max(this=share.copy())),
        "since": exp.column("first_time"),
        "samples": exp.column("samples"),
    }
    names = "version_id bucket_no first_time samples floor"
    same = [(7, 0, 0, 10, 0.5), (9, 0, 0, 10, None)]
    kept = [
        (7, 1, 10, 11, 0.5),
        (7, 3, 30, 10, 0.5),
        (7, 3, 30, 10, 0.5),
        (8, 0, 0, 9, 0.25),
        (8, 9, 9, 9, 1.0),
    ]
    made = [(7, 1, 11, 10, 0.5), (7, 3, 30, 10, 0.5), (7, 4, 40, 10, 0.5), (8, 0, 0, 9, 0.75)]
    found = step(
        "stored/checking/compared",
        slots,
        state_rows=rows(names, *same, *kept),
        recomputed_rows=rows(names, *same, *made),
    )
    # stored, only_stored, only_recomputed, samples_then, samples_now, since, owner_id
    assert sorted(found, key=lambda row: row[-1]) == [(4, 2, 2, 21, 20, 10, 7), (1, 1, 1, 0, 0, 0, 8)]


def test_numbers_go_on_from_the_largest() -> None:
    two = rows("monitor_id channel_id version_id support_id run_id", (2, 4, 6, 8, 10), (1, 3, 5, 7, 9))
    names = ("monitor", "channel", "version", "calibration", "extent", "bounds", "run")
    found = step("stored/state/last_numbers", **{f"stored_{name}": two for name in names})
    assert dict(found) == {
        **{"monitor": 2, "channel": 4, "version": 6},
        **{"calibration": 6, "extent": 6, "support": 8, "run": 10},
    }


@pytest.mark.parametrize(
    ("oldest", "pruned", "expected"),
    [
        (28, 0, (1, 0, 5, 2, 30, 28)),  # the context of the bucket after 2 begins at 28
        (29, 0, (1, 0, 5, 3, 40, 38)),
        (39, 0, (1, 0, 5, 3, 40, 38)),  # none is whole: the newest
        (0, 1, (1, 1, 15, 2, 30, 28)),  # what was pruned leaves a window of two
    ],
)
def test_what_stays_where_rows_have_gone(oldest: int, pruned: int, expected: tuple[int, ...]) -> None:
    buckets = [(1, n, 10 * n + 5, 10 * n + 10, 10 * n + 8) for n in range(pruned, 4)]
    found = step(
        "stored/scoring/whole",
        stored_visible_bucket=rows("version_id bucket_no first_time last_time context_time", *buckets),
        newest=rows("version_id oldest_bucket buckets", (1, pruned, 2)),
        oldest_rows=rows("version_id oldest_time", (1, oldest)),
    )
    assert found == [expected]


@pytest.mark.parametrize(
    ("lookback", "repair_from", "pruned_stay", "expected"),
    [
        (10, 2**62, 1, (1, 0, 1, 20, 18)),  # 30 is within the lookback of 40
        (9, 2**62, 1, (1, 0, 2, 30, 28)),
        (0, 20, 1, (1, 0, 0, 10, 8)),  # what ends at the instant is repaired
        (2**62, 2**62, 1, (1, 0, -1, None, None)),
    ],
)
def test_the_last_bucket_that_stays(
    lookback: int, repair_from: int, pruned_stay: int, expected: tuple[int | None, ...]
) -> None:
    found = step(
        "stored/scoring/restart",
        {"lookback": lookback, "repair_from": repair_from, "pruned_stay": pruned_stay},
        stored_visible_bucket=rows(
            "version_id bucket_no last_time context_time",
            *((1, n, 10 * n + 10, 10 * n + 8) for n in range(4)),
        ),
        newest=rows("version_id newest_time oldest_bucket buckets", (1, 40, 0, 2)),
    )
    assert found == [expected]


def test_of_a_pruned_version_the_oldest_window_stays() -> None:
    asked = {
        "stored_visible_bucket": rows(
            "version_id bucket_no last_time context_time",
            *((1, n, 10 * n, 10 * n - 2) for n in (5, 6, 7, 8)),
        ),
        "newest": rows("version_id newest_time oldest_bucket buckets", (1, 80, 5, 2)),
    }
    slots = {"lookback": 2**62, "repair_from": 2**62}
    assert step("stored/scoring/restart", {**slots, "pruned_stay": 1}, **asked) == [(1, 5, 6, 60, 58)]
    assert step("stored/scoring/restart", {**slots, "pruned_stay": 0}, **asked) == [
        (1, 5, -1, None, None)
    ]


def test_a_plan_expects_the_samples_that_a_vector_and_stillness_reach_back() -> None:
    """(m - 1) tau of them, one where m is 1, and still_after - 1 more."""
    frozen = (
        "version_id channel_id asset channel support_id lo hi m tau bins window_length stride max_gap "
        "still_after score_from calibration_end calibration_readings first_scored run_up_from "
        "created program_column"
    )

    def version(number: int, m: int, still_after: int | None) -> tuple[int | float | str | None, ...]:
        of_parameters = (m, 4, 8, 10, 2, None, still_after, None)
        return (number, number, "a", "x", 1, 0.0, 1.0, *of_parameters, 99, 100, 100, 88, 5, None)

    versions = [
        version(1, 3, None),
        version(2, 1, None),
        version(3, 3, 6),
        version(4, 3, 6),
        version(5, 3, 6),
    ]
    found = step(
        "stored/scoring/plan",
        {"long_ago": BEFORE_ALL},
        active=rows(frozen, *versions),
        restart=rows(
            "version_id oldest_bucket last_staying last_time context_time",
            *((number, 0, 7, 150, 140) for number in (1, 2, 3)),
            (4, 0, 7, 150, BEFORE_ALL),
        ),
        last_reads=rows(
            "version_id read_until looked_at counted_at", (1, 170, 180, 181), (2, 1, 2, BEFORE_ALL)
        ),
    )
    # version, then first_bucket, first_scored, read_from, context_expected, oldest_bucket, restarts, ...
    assert [(row[0], *row[17:-1]) for row in found] == [
        (1, 8, 151, 140, 8, 0, 1, 170, 180, 181),
        (2, 8, 151, 140, 1, 0, 1, 1, 2, 5),
        (3, 8, 151, 140, 13, 0, 1, BEFORE_ALL, BEFORE_ALL, 5),
        (4, 8, 151, BEFORE_ALL, None, 0, 1, BEFORE_ALL, BEFORE_ALL, 5),
        (5, 0, 100, 88, None, 0, 0, BEFORE_ALL, BEFORE_ALL, 5),
    ]


def test_a_run_up_is_complete_where_no_sample_is_missing_and_none_is_too_many() -> None:
    found = step(
        "stored/scoring/run_up",
        {"span": 2, "settings": []},
        cohort=rows("channel_id lo hi read_from", *((n, 0.0, 1.0, 50) for n in (1, 2, 3))),
        seen=rows("channel_id missing_samples context_rows", (1, 0, 2), (2, 1, 2), (3, 0, 3)),
    )
    assert [(row[0], row[-1]) for row in found] == [(1, 1), (2, 0), (3, 0)]


def test_rows_beyond_the_first_of_an_instant_were_read_too() -> None:
    found = step(
        "stored/scoring/seen",
        samples=rows("channel_id time value", (1, 10, 0.5), (1, 20, None), (1, 30, 0.5)),
        timeline=rows("channel_id repeats", (1, 2)),
        cohort=rows("channel_id first_scored", (1, 20)),
    )
    assert found == [(1, 3 + 2, 1, 1, 30)]


def test_on_trust_no_instant_is_repeated() -> None:
    assert step("census/trusted_timeline", cohort=rows("channel_id", (1,), (2,))) == [
        (1, 0),
        (2, 0),
    ]


def test_bounds_that_are_there_twice_contradict_a_version() -> None:
    bounds = (
        "support_id calibrated_lo calibrated_hi calibration_vectors cells seen_once blocks verdict "
        "floor floor_sd floor_max finest_bins vectors_needed"
    )
    one = (9, None, None, 0, 0, 0, 0, "no_data", None, None, None, None, None)
    asked = {
        "checked": rows(
            "version_id channel_id support_id parent_id version_no status reason",
            (1, 3, 9, None, 1, "active", "first calibration"),
        ),
        "stored_support": rows(
            "support_id cell_key visits first_time last_time first_block last_block", *[(0,) * 7]
        ),
        "stored_block": rows("support_id channel_id block vectors novel first_time last_time", (0,) * 7),
    }
    assert step("stored/checking/inconsistent_versions", stored_bounds=rows(bounds, one), **asked) == []
    assert step(
        "stored/checking/inconsistent_versions", stored_bounds=rows(bounds, one, one), **asked
    ) == [(1, 0, 1, 0, 0)]


def test_a_version_reads_from_where_all_of_its_first_vector_is_there() -> None:
    """(m - 1) tau samples before it, and still_after - 1 more; with fewer, from the beginning."""
    names = (
        "version_id channel_id stored_channel_id stored_support_id parent_id version_no reason m tau "
        "bins window_length stride max_gap still_after score_from target_floor least_vectors "
        "is_robust program_column program_weight settings_hash method_hash"
    )

    def numbered(version: int, still_after: int | None) -> tuple[int | float | str | None, ...]:
        head = (version, version, version + 20, version + 40, version + 60, 2, "other settings")
        return (*head, 3, 2, 8, 10, 2, None, still_after, None, 0.05, 1, 1, None, None, "s", "m")

    found = step(
        "stored/calibrating/version_rows",
        {"long_ago": BEFORE_ALL, "created": 77},
        numbering=rows(names, *(numbered(n, 4 if n > 3 else None) for n in range(1, 6))),
        bounds=rows(
            "channel_id calibration_end first_scored calibration_samples",
            *((n, 90, 91, 30) for n in range(1, 6)),
        ),
        run_up=rows("channel_id read_from context_rows", (1, 80, 4), (2, 80, 3), (4, 70, 7), (5, 70, 4)),
        recount=rows("channel_id calibration_readings", (1, 31)),
    )
    # version_id, channel_id, parent_id, run_up_from, calibration_readings
    assert [(row[0], row[1], row[3], row[20], row[21]) for row in found] == [
        (1, 21, 61, 80, 31),
        (2, 22, 62, BEFORE_ALL, 0),
        (3, 23, 63, BEFORE_ALL, 0),
        (4, 24, 64, 70, 0),
        (5, 25, 65, BEFORE_ALL, 0),
    ]


def test_an_extent_is_that_of_one_width() -> None:
    found = step(
        "stored/calibrating/extent_rows",
        {"g": 4},
        learnt_limits=rows(
            "channel_id g vectors calibration_length order_ratio",
            (1, 4, 60, 70, 800),
            (1, 25, 61, 71, 801),
        ),
        numbering=rows("channel_id version_id", (1, 5)),
    )
    assert found == [(5, 60, 70, 800)]


def test_fifty_judgements_before_the_first_new_one_are_read_again() -> None:
    slots = {"root": fill("alarms/root", {"count": column("novel")}), "near": ALWAYS}
    found = step(
        "stored/alarms/judged_with_limits",
        slots,
        judged_windows=rows("channel_id judgement_no novel", (3, 60, 4)),
        judged_until=rows("version_id channel_id first_judgement", (7, 3, 60)),
        limit_spans=rows(
            "channel_id limit_no from_judgement until_judgement reference height cap",
            (3, 1, 0, 20, 500, 900, 450),
            (3, 2, 20, 2**62, 600, 800, 400),
        ),
        stored_visible_judgement=rows(
            "version_id judgement_no root is_open last_zero", *((7, n, n, 0, n - 1) for n in range(70))
        ),
    )
    kept = [
        (3, 0, n, n, *((500, 900, 450, 0) if n < 20 else (600, 800, 400, 20)), 0, n - 1)
        for n in range(10, 60)
    ]
    assert found == [*kept, (3, 0, 60, 2091, 600, 800, 400, 20, -1, None)]


def test_an_episode_that_opens_within_calibration_is_still_proving() -> None:
    """Of nine blocks, numbered from 0: what opens at judgement 8 does, what opens at 9 does not."""
    found = step(
        "stored/alarms/raised_episodes",
        {"near": ALWAYS},
        merged=rows("channel_id onset first_judgement last_judgement", (3, 5, 8, 8), (3, 9, 9, 10)),
        followed=rows("channel_id version_id", (3, 7)),
        stored_visible_judgement=rows(
            "version_id judgement_no first_time last_time evidence height",
            *((7, n, 100 * n, 100 * n + 99, 10 * n, 50 + n) for n in range(6, 12)),
        ),
        stored_limit=rows("version_id blocks reason", (7, 0, None), (7, 9, None), (7, 99, "short")),
    )
    assert found == [
        (3, 7, 5, 8, 8, None, 800, 899, 80, 58, 1),  # the judgement of its onset was pruned
        (3, 7, 9, 9, 10, 900, 900, 1099, 100, 59, 0),
    ]


def test_judgements_from_one_to_another_hold_both() -> None:
    names = "version_id judgement_no first_time last_time novel root reference height evidence is_open"
    judgements = rows(names, *((n // 5, n, n, n, n, n, n, n, n, 0) for n in range(10)))
    slots = {"version_id": 1, "first": 6, "last": 8}
    found = step("stored/alarms/raised_judgements", slots, stored_visible_judgement=judgements)
    assert [row[0] for row in found] == [6, 7, 8]


def test_judgements_that_are_open_are_looked_at_from_the_first_that_is_asked_for() -> None:
    found = step(
        "stored/alarms/open_judgements",
        {"near": ALWAYS},
        followed=rows("channel_id version_id since_judgement", (3, 7, 5)),
        stored_visible_judgement=rows(
            "version_id judgement_no is_open last_zero",
            (7, 4, 1, 2),
            (7, 5, 1, 2),
            (7, 6, 0, 6),
            (8, 9, 1, 0),
        ),
    )
    assert found == [(3, 0, 5, 1, 2)]


def test_what_changed_after_a_number_is_not_what_had_it() -> None:
    names = "monitor seq episode_id what noticed_at asset channel status is_proving "
    names += "basis incident_id signals_together is_message"
    said = ("a", "x", "open", 0, "table", 1, 1, 1)
    events = rows(names, *(("gam", n, 1, "opened", n, *said) for n in (1, 2, 3)))
    found = step("stored/alarms/event_rows", {"monitor": "gam", "after": 2}, stored_alarm_event=events)
    assert [row[0] for row in found] == [3]


def test_a_run_that_gives_way_is_withdrawn() -> None:
    names = (
        "run_id version_id from_bucket read_from read_to rows_read context_rows context_expected "
        "calibration_readings lookback settled_bucket settled_time settled_context started committed "
        "planned_from hides"
    )
    two = rows(names, tuple(range(17)), tuple(range(1, 18)))
    assert step("stored/state/withdrawal", {"run_id": 1}, stored_run=two) == [(*range(1, 18), 1)]


def test_a_reading_at_either_end_of_an_interval_counts() -> None:
    """And a second value of an instant, a missing one too; not what comes again."""
    readings = [
        (3, 9, 0.0),
        (3, 10, 0.0),
        (3, 10, 0.0),
        (3, 15, 1.0),
        (3, 15, 2.0),
        (3, 20, 1.0),
        (3, 20, None),
    ]
    found = step(
        "stored/scoring/recount",
        identified=rows("channel_id time value", *readings, (3, 21, 0.0)),
        calibration=rows("channel_id time_from time_to", (3, 10, 20)),
    )
    assert found == [(3, 1 + 2 + 2)]


def test_keys_that_are_there_twice_are_told_of_each_kind() -> None:
    one = rows("monitor_id channel_id version_id", (1, 2, 3))
    two = rows("monitor_id channel_id version_id", (1, 2, 3), (1, 2, 3))
    for kind, key in (("monitor", 1), ("channel", 2), ("version", 3)):
        tables = {
            f"stored_{name}": two if name == kind else one for name in ("monitor", "channel", "version")
        }
        assert step("stored/state/doubled", **tables) == [(kind, key)]


def test_counts_of_rows_without_a_place_go_when_they_are_old() -> None:
    found = step(
        "stored/pruning/expired_unplaced",
        {"monitor": "gam", "unplaced_from": 50},
        stored_unplaced=rows("monitor_id started", (1, 40), (1, 50), (1, 60), (2, 40)),
        stored_monitor=rows("monitor_id name", (1, "gam"), (2, "other")),
    )
    assert found == [(1, 40)]


def test_cells_of_an_alarm_are_its_own_in_order() -> None:
    names = (
        "monitor episode_id version_id cell_rank axis cell_key visits first_tick last_tick "
        "samples_before place value_from value_to steps displacement program"
    )

    def cell(monitor: str, episode: int, version: int, rank: int, axis: int) -> tuple[int | str, ...]:
        return (monitor, episode, version, rank, axis, *range(11))

    asked = [("gam", 2, 5, 2, 0), ("gam", 2, 5, 1, 1), ("gam", 2, 5, 1, 0)]
    others = [("gam", 3, 5, 7, 0), ("gam", 1, 5, 7, 0), ("gam", 2, 6, 7, 0), ("other", 2, 5, 7, 0)]
    found = step(
        "stored/alarms/alarm_cells",
        {"monitor": "gam", "episode_id": 2, "version_id": 5},
        stored_alarm_cell=rows(names, *(cell(*one) for one in (*asked, *others))),
    )
    assert [(row[0], row[5]) for row in found] == [(1, 0), (1, 1), (2, 0)]


def test_bands_of_an_alarm_are_those_that_stand_out() -> None:
    names = (
        "monitor episode_id version_id band excess place value_from value_to novel visits "
        "calibration_novel calibration_visits"
    )
    said = [(0, 0.0), (1, 0.5), (2, -0.25), (3, 2.0), (4, 0.25)]
    bands = [("gam", 2, 5, band, excess, f"band {band}", *range(6)) for band, excess in said]
    found = step(
        "stored/alarms/alarm_bands",
        {"monitor": "gam", "episode_id": 2, "version_id": 5, "most": 2},
        stored_alarm_band=rows(names, *bands, ("gam", 1, 5, 9, 9.0, "of another", *range(6))),
    )
    assert [(row[0], row[-1]) for row in found] == [("band 3", 2.0), ("band 1", 0.5)]


def test_alarms_are_told_most_urgent_first_then_newest_first_with_all_that_was_noted() -> None:
    noted = (
        *("asset", "channel", "since_tick", "first_tick", "last_tick", "basis", "stated_rate", "asked"),
        *(
            "signals_open",
            "incident_id",
            "signals_together",
            "label",
            "label_until",
            "note",
            "merged_into",
        ),
        *("onset", "first_judgement", "last_judgement", "seq", "channel_id", "version_id"),
    )

    def alarm(monitor: str, number: int, asks: int, told_as: str) -> tuple[int | str, ...]:
        said = (monitor, number, "open", told_as, asks, 3, 2)
        return (*said, *(f"{name} of {number}" for name in noted))

    names = "monitor episode_id status told_as needs_attention evidence height " + " ".join(noted)
    alarms = rows(
        names,
        *(alarm("gam", 1, 0, "open"), alarm("gam", 2, 1, "ended"), alarm("gam", 3, 0, "ended")),
        *(alarm("gam", 4, 0, "ended"), alarm("other", 5, 1, "open"), alarm("gam", 6, 0, "proving")),
    )
    found = step("stored/alarms/alarm_rows", {"monitor": "gam"}, stored_alarm=alarms)
    assert [row[0] for row in found] == [2, 6, 1, 4, 3]
    of = dict(zip(noted, alarm("gam", 2, 1, "ended")[7:], strict=True))
    assert found[0] == (
        *(2, of["asset"], of["channel"], "ended", 1, of["since_tick"], of["first_tick"]),
        *(of["last_tick"], 1.5, *(of[name] for name in noted[5:18]), 3, 2, *(of[n] for n in noted[18:])),
    )


def test_a_version_is_checked_with_what_the_newest_records_say_of_it() -> None:
    """The furthest horizon; the newest run that read, and the newest that counted calibration."""
    names = (
        "version_id channel_id support_id parent_id version_no status reason m tau bins window_length "
        "stride max_gap still_after program_column score_from target_floor least_vectors is_robust "
        "calibration_end "
        "first_scored calibration_readings run_up_from"
    )

    def version(
        number: int, channel: int, still_after: int | None
    ) -> tuple[int | str | float | None, ...]:
        settings = (3, 4, 8, 10, 2, None, still_after, None, None, 0.05, 1, 1)
        return (number, channel, 40, None, 1, "active", "first calibration", *settings, 90, 91, 30, 80)

    found = step(
        "stored/checking/checked",
        {"monitor_id": 1},
        stored_version=rows(
            names, version(1, 3, None), version(2, 3, 6), version(3, 4, None), version(4, 5, None)
        ),
        stored_channel=rows(
            "channel_id monitor_id asset channel", (3, 1, "a", "x"), (4, 1, "b", "x"), (5, 2, "a", "x")
        ),
        stored_bounds=rows("support_id calibrated_lo calibrated_hi", (40, 0.5, 2.5), (41, 0.0, 9.0)),
        stored_horizon=rows(
            "version_id first_bucket first_novel", (2, 5, 6), (2, 8, 9), (2, 7, 7), (3, 1, 1)
        ),
        stored_finished_run=rows(
            "version_id run_id started read_to settled_bucket calibration_readings",
            *((2, 1, 5, 100, 4, 31), (2, 2, 6, 200, 5, None), (2, 3, 7, None, None, 32)),
            *((3, 1, 5, 110, 4, None), (3, 4, 8, 90, 3, None)),
        ),
        stored_block=rows("support_id channel_id first_time", (40, 3, 12), (40, 3, 11), (40, 4, 9)),
        stored_calibration=rows("version_id time_from", (2, 9), (2, 8)),
    )
    assert [row[22:26] for row in found] == [
        (30, 11, None, None),
        (30, 11, 8, 7),
        (30, 9, None, 8),
    ], "calibration_readings, taught_from, calibration_from, started"
    # version_id, context_rows, lo, hi, is_active, first_bucket, first_novel, read_to, counted_readings
    assert [(row[0], row[-10], *row[-8:-1]) for row in found] == [
        (1, 8, 0.5, 2.5, 0, 0, 0, None, None),
        (2, 13, 0.5, 2.5, 1, 8, 9, 200, 32),
        (3, 8, 0.5, 2.5, 1, 1, 1, 90, None),
    ]


def test_calibration_is_counted_one_by_one_where_an_instant_occurs_twice() -> None:
    """Once is enough."""
    found = step(
        "stored/calibrating/repeating_calibration",
        {},
        calibration=rows("channel_id time_from time_to", (1, 0, 9), (2, 0, 9), (3, 5, 9), (3, 12, 20)),
        timeline=rows("channel_id repeats", (1, 0), (2, 1), (3, 4)),
    )
    assert sorted(found) == [(2, 0, 9), (3, 5, 9), (3, 12, 20)]


def test_a_run_writes_from_the_first_bucket_that_is_not_stored_so() -> None:
    """Channels: 1 as before, 2 other figures, 3 other cells, 4 more, 5 fewer, 6 none, 7 stands still."""
    kept = f"channel_id {BUCKET.replace(' novel', ' still novel')}"
    made = [(channel, 3, 10, 19, 15, 10, 1, 0) for channel in (1, 2, 3, 4, 7)]
    made += [(channel, 4, 20, 29, 25, 10, 1, 0) for channel in (1, 2, 3, 4, 7)]
    before = [(*row[:6], None, *row[6:]) for row in made if row[:2] != (4, 4)]
    before[before.index((2, 4, 20, 29, 25, 10, None, 1, 0))] = (2, 4, 20, 29, 25, 11, None, 1, 0)
    before += [(5, 3, 10, 19, 15, 10, None, 1, 0)]
    cell = "channel_id bucket_no cell_key visits first_time last_time"
    cells = [(channel, 0, 8, 1, 12, 12) for channel in (1, 2, 3)]
    former = [(channel, 3, *row) for channel, _, *row in cells[:2]] + [(3, 3, 9, 1, 12, 12)]
    found = step(
        "stored/scoring/changed",
        cohort=rows("channel_id version_id first_bucket", *((n, n + 10, 3) for n in range(1, 8))),
        new_buckets=rows(f"channel_id {BUCKET}", *made),
        still_counts=rows("channel_id bucket_no still", (7, 4, 2)),
        novel_cells=rows(cell, *cells),
        former_buckets=rows(kept, *before),
        former_novel=rows(cell, *former),
    )
    firsts = {1: 5, 2: 4, 3: 3, 4: 4, 5: 3, 6: 3, 7: 4}
    assert sorted(found) == [(n, n + 10, first, int(n not in (1, 6))) for n, first in firsts.items()]


def test_what_is_stored_of_new_buckets_is_what_is_seen_of_them() -> None:
    figures = BUCKET.removeprefix("bucket_no ")
    bucket = rows(
        f"version_id run_id bucket_no {figures} novel_in_window",
        *((5, run, n, 1, 2, 3, 4, 5, 6, 9) for run, n in ((1, 2), (1, 3), (2, 4))),
    )
    written = rows(
        "version_id run_id bucket_no still", (5, 1, 2, 0), (5, 1, 3, 7), (5, 1, 4, 9), (5, 2, 4, 8)
    )
    cohort = rows("channel_id version_id first_bucket", (1, 5, 3))
    slots = {"near": ALWAYS}
    found = step(
        "stored/scoring/former_buckets",
        {**slots, "within": ALWAYS, "programs": []},
        cohort=cohort,
        stored_visible_bucket=bucket,
        stored_bucket=written,
    )
    assert found == [(1, 5, 3, 1, 2, 3, 4, 7, 5, 6, 9), (1, 5, 4, 1, 2, 3, 4, 8, 5, 6, 9)]
    cells = rows(
        "version_id bucket_no cell_key visits first_time last_time",
        *((5, n, 9, 1, 2, 3) for n in (2, 3, 4)),
    )
    found = step("stored/scoring/former_novel", slots, cohort=cohort, stored_visible_novel=cells)
    assert found == [(1, 5, 3, 9, 1, 2, 3), (1, 5, 4, 9, 1, 2, 3)]


def test_of_what_was_made_the_rest_is_not_written() -> None:
    made = [(1, 5, n, 1, 2, 3, 4, 5, 6) for n in (2, 3, 4)]
    found = step(
        "stored/scoring/written",
        new_buckets=rows(f"channel_id version_id {BUCKET}", *made),
        changed=rows("channel_id version_id first_bucket", (1, 5, 3)),
    )
    assert found == made[1:]
