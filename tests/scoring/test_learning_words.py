"""The plain sentences on a learning curve: a verdict word, how much, and no statistics."""

import re
from itertools import product

import numpy as np
import pytest

from app.scoring.learning import learning_curves
from app.scoring.measures import TRIAL_MEASURES

STATISTICS = re.compile(
    r"Mann|Kendall|\bp [<=]|95 %|exponential|power law|AICc|median|chance|constant|trend|-", re.IGNORECASE
)
FALLING = 1.5 + 4.0 * np.exp(-np.arange(1.0, 29.0) / 3.0) + np.random.default_rng(3).normal(0, 0.1, 28)


def curve_of(name: str, values: np.ndarray, sessions: int = 0) -> dict[str, object]:
    """Return the curve of a measure over trials in so many sessions; 0: not known."""
    each = -(-len(values) // sessions) if sessions else 0
    rows = [
        {"number": i + 1, name: float(value)} | ({"session": i // each + 1} if sessions else {})
        for i, value in enumerate(values)
    ]
    return learning_curves(rows)[name]


def test_what_became_better_is_said_with_its_amount_and_its_level() -> None:
    assert curve_of("e_diff", FALLING, sessions=4)["text"] == (
        "Better than noise over 28 trials in 4 sessions: the area off the path fell by about 1.74 m², "
        "from 3.30 to 1.55 m². It levels off at about 1.53 m²."
    )


def test_noise_has_neither_an_amount_nor_a_direction() -> None:
    noise = 3.0 + np.random.default_rng(8).normal(0, 0.3, 22)
    text = curve_of("e_diff", noise)["text"]
    assert re.fullmatch(r"Within noise over 22 trials: the area off the path was about \d\.\d\d m²\.", str(text))


@pytest.mark.parametrize(
    ("name", "values", "begin"),
    [
        ("e_diff", -FALLING + 8, "Worse than noise over 28 trials: the area off the path rose by about "),
        ("gap_clearance", FALLING, "Worse than noise over 28 trials: the narrowest clearance in a gap fell by about "),
        ("gap_clearance", -FALLING + 8, "Better than noise over 28 trials: "),
        ("mean_speed", FALLING, "Over 28 trials: the mean speed was about "),
    ],
)
def test_the_word_is_that_of_the_verdicts(name: str, values: np.ndarray, begin: str) -> None:
    assert str(curve_of(name, values)["text"]).startswith(begin)


def test_numbers_are_written_as_everywhere_on_the_pages() -> None:
    rising = curve_of("sparc", -FALLING)
    assert "from \u22123.30 to \u22121.55." in str(rising["text"])
    assert "-" not in str(rising["text"]) + "".join(rising["details"])  # type: ignore[arg-type]


def test_the_level_of_a_count_is_never_below_none() -> None:
    counts = np.round(6 * np.exp(-np.arange(28) / 5))
    text = str(curve_of("collisions", counts, sessions=7)["text"])
    assert "fell by about 5, from 5 to 0." in text
    assert "\u2212" not in text


def test_no_plain_sentence_has_a_statistic_and_all_of_them_are_in_the_details() -> None:
    for case in product(TRIAL_MEASURES, (5, 8, 12, 28), (1.0, -1.0, 0.0)):
        name, count, sign = case
        curve = curve_of(name, sign * FALLING[:count], sessions=4 if count == 28 else 1)
        assert STATISTICS.findall(f"{curve['text']} {curve['sessions'] or ''}") == [], case
        details = curve["details"]
        assert isinstance(details, list), case
        of_sessions = count == 28 and name != "mean_speed"  # which leads in no task
        assert len(details) == (0 if count == 5 else 2 if of_sessions else 1), case
        assert all("99 %" in one or "medians of" in one for one in details), case
