"""What own repetitions bring: as many hits are expected, and are surer."""

from app.calibration.linear_map import Forecast
from app.calibration.prior.hit_uncertainty import deviation_of_hits, hits_with_prompts


def test_hits_with_prompts_are_as_many_and_surer() -> None:
    without = Forecast(value=70.0, uncertainty=deviation_of_hits(0))
    prompted = hits_with_prompts(without)
    assert (prompted.value, prompted.uncertainty) == (70.0, deviation_of_hits(3))
    assert prompted.uncertainty < 0.75 * without.uncertainty
