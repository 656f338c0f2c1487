"""The verdicts of a person's interface tests: the newest against the one before, and against the first."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from app.quantities import Document
from app.scoring.measures import TEST_MEASURES
from app.scoring.verdict.detectable_change import LEVEL_OF_TESTS, variance_of
from app.scoring.verdict.leading_measures import LEADING_OF_TESTS
from app.scoring.verdict.measure_scales import least_spread, to_scale
from app.scoring.verdict.measure_verdict import FEWEST, Difference, Verdict, verdicts_on
from app.scoring.verdict.spread import OwnSpread, Series, Variance, own_spread

Tests = Sequence[Mapping[str, Any]]
"""In the order done; each has `number`, and measures by name."""


class InterfaceVerdicts(Document):
    """The verdicts on the newest interface test against an earlier one."""

    earlier: int  # number of the test
    later: int
    verdicts: dict[str, Verdict]  # measure -> verdict; without the measures that one of the two does not have


def interface_verdicts(tests: Tests) -> list[InterfaceVerdicts]:
    """Compare the newest of a person's tests with the one before and with the first; empty for fewer than two."""
    if len(tests) < 2:
        return []
    return [_against(tests, place) for place in dict.fromkeys((len(tests) - 2, 0))]


def verdicts_between(tests: Tests, earlier: int, later: int) -> InterfaceVerdicts | None:
    """Compare two of a person's tests by their numbers, as of the later one; None when one of them is not there."""
    numbers = [test["number"] for test in tests]
    if earlier not in numbers or later not in numbers:
        return None
    return _against(tests[: numbers.index(later) + 1], numbers.index(earlier))


def _against(tests: Tests, place: int) -> InterfaceVerdicts:
    """Compare the newest test with that at `place`."""
    all_differences = {name: _difference(name, tests, place) for name in TEST_MEASURES}
    differences = {name: difference for name, difference in all_differences.items() if difference is not None}
    return InterfaceVerdicts(
        earlier=tests[place]["number"],
        later=tests[-1]["number"],
        verdicts=verdicts_on(differences, LEADING_OF_TESTS, together=LEVEL_OF_TESTS)[0],
    )


def _difference(name: str, tests: Tests, place: int) -> Difference | None:
    """Return the difference of the newest test from that at `place`; None when one of them has no such measure."""
    earlier, later = tests[place].get(name), tests[-1].get(name)
    if earlier is None or later is None:
        return None
    measured = [(test["number"], test[name]) for test in tests if test.get(name) is not None]
    numbers = np.array([number for number, _ in measured], dtype=np.float64)
    values = to_scale(name, np.array([value for _, value in measured], dtype=np.float64))
    earlier_value, later_value = to_scale(name, np.array([earlier, later], dtype=np.float64)).tolist()
    variance = None
    if len(measured) >= FEWEST:
        # Each test stands for itself, as a session of one trial: what differs from test to test is the noise.
        series = Series(numbers, np.arange(len(measured)), values)
        between_tests = own_spread(series.where(series.session < len(measured) - 1)).mean
        mean = Variance(max(between_tests.value, least_spread(name, values) ** 2), between_tests.df)
        variance = variance_of(OwnSpread(Variance(0.0, math.inf), mean, 1.0), (1, 1), (1, 1))
    return Difference(earlier_value, later_value, len(measured), variance)
