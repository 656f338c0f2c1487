"""What own repetitions bring: the same forecast as `expected_hits` with repetitions, and never more than all."""

from app.calibration.prior.prompting import BROUGHT, deviation_of_hits, hits_with_prompts
from app.calibration.profile import Forecast


def test_hits_with_prompts_are_surer_and_a_few_more() -> None:
    without = Forecast(value=70.0, uncertainty=deviation_of_hits(0))
    prompted = hits_with_prompts(without)
    assert (prompted.value, prompted.uncertainty) == (70.0 + BROUGHT, deviation_of_hits(3))
    assert prompted.uncertainty < 0.7 * without.uncertainty


def test_there_are_no_more_hits_than_movements() -> None:
    assert hits_with_prompts(Forecast(value=99.5, uncertainty=1.0)).value == 100.0
