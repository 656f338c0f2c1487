"""The comparison of a fixed with an adapted map, and its claim."""

import pytest

from app.study.comparison import compare, table
from app.study.sessions import StudySessionTrial


def trial(seed, mode, session, e_diff, reached=True, felt=0.0, flips=0):
    figures = {"e_diff": e_diff, "dist": 10.0, "time": 30.0, "reached": reached, "faults": 0}
    adapted = {"proposed": int(felt > 0.0), "felt_change": felt, "angle_deg": 2.0 if felt else 0.0, "flips": flips}
    known = {"trial": 1, "refused": 0, "dead_zone": 0.15, "full": 2.0, "from_calibration_deg": 0.0}
    return StudySessionTrial(seed=seed, mode=mode, session=session, **figures, **adapted, **known)


def study(ratio, seeds=8, **how):
    fixed = [trial(s, "off", n, 1.0 + 0.1 * s) for s in range(seeds) for n in (1, 2)]
    other = [
        trial(s, "auto", n, (ratio if n == 2 else 1.0) * (1.0 + 0.1 * s), **how) for s in range(seeds) for n in (1, 2)
    ]
    return fixed, other


def test_a_clear_gain_holds_the_claim() -> None:
    found = compare(*study(0.6, felt=0.04))
    assert found["last_session"]["median_relative"] == pytest.approx(-0.4)
    assert found["last_session"]["interval"] == pytest.approx((-0.4, -0.4))
    assert found["claim_holds"]
    assert found["sessions"][0]["relative"] == pytest.approx(0.0)
    assert found["applied"]["largest_felt_change"] == 0.04


def test_the_later_sessions_count_every_trial_also_those_that_stood_still() -> None:
    fixed, other = study(1.0)
    fixed = [
        trial(one.seed, "off", 2, 10.0, reached=False) if one.session == 2 and one.seed < 2 else one for one in fixed
    ]
    later = compare(fixed, other)["later_sessions"]
    assert later is not None
    assert later["interval"] is not None
    means = [(2 * 10.0 + sum(1.0 + 0.1 * seed for seed in range(2, 8))) / 8, 1.35]
    assert (later["fixed"], later["adapted"]) == pytest.approx(means)
    assert later["relative"] == pytest.approx(means[1] / means[0] - 1)
    assert later["interval"][0] <= later["relative"] <= later["interval"][1] <= 0.0
    assert (later["reached_fixed"], later["reached_adapted"]) == (0.75, 1.0)
    assert "from session 2 on" in table(compare(fixed, other))
    one = [row for row in fixed if row.session == 1], [row for row in other if row.session == 1]
    assert compare(*one)["later_sessions"] is None


@pytest.mark.parametrize(
    ("ratio", "how"), [(0.8, {}), (1.2, {}), (0.6, {"felt": 0.11}), (0.6, {"felt": 0.04, "flips": 1})]
)
def test_a_small_gain_a_loss_a_felt_step_or_a_flip_do_not(ratio, how) -> None:
    assert not compare(*study(ratio, **how))["claim_holds"]


def test_seeds_that_did_not_reach_the_goal_are_not_compared() -> None:
    fixed, other = study(0.5)
    fixed = [trial(one.seed, "off", 2, 11.0, reached=False) if one.session == 2 else one for one in fixed]
    found = compare(fixed, other)
    assert found["sessions"][1]["seeds_that_always_drove"] == 0
    assert found["sessions"][1]["relative"] is None
    assert found["sessions"][1]["reached_fixed"] == 0.0
    last = found["last_session_in_which_most_drove_with_both"]
    assert last is not None
    assert last["session"] == 1


def test_the_table_has_a_row_for_each_session_and_seed() -> None:
    text = table(compare(*study(0.6)))
    assert len(text.splitlines()) == 2 + 2 + 3 + 8 + 2 + 2
    assert "−40 %" in text
