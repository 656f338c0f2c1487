"""A map from other people: it drives somebody new, follows turned rings and other gains, and says what it cannot."""

import numpy as np
import pytest
from calibration.prior.simulated_wearers import RATE, SENSORS, Wearer, prior_of, sleeve

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition
from app.calibration.linear_map import Arrangement, Forecast
from app.calibration.prior.hit_uncertainty import deviation_of_hits, hits_with_prompts
from app.calibration.prior.map_prior import MapPrior, PriorError
from app.calibration.prior.prior_map import LEAST_FULL, expected_hits, own_full, own_peaks, with_prior_maps
from app.calibration.prior.solving import OwnFrames
from app.calibration.vocabulary import standard_parameters
from app.layout import ShirtLayout
from app.pipeline.replay.batch import decode_block

STRANGERS = range(101, 107)


@pytest.fixture(scope="module")
def prior():
    return MapPrior.of(prior_of(range(1, 9)))


def fitted(wearer, prior, values=None, prompts=0, layout=None):
    values = wearer.values if values is None else values
    free = values[: round(10 * wearer.rate)]
    stretches = [wearer.stretch(prompts, values)] if prompts else []
    repetitions = [
        Repetition("right_elbow", values[max(0, one.start - 25) : one.stop + 50], slice(25, 25 + one.stop - one.start))
        for stretch in stretches
        for one in stretch.moving[1:]
    ]
    clean = CleanRecording.of(layout or sleeve(), wearer.rate, free=free, repetitions=repetitions, stretches=stretches)
    return with_prior_maps(fit_profile(clean), prior, clean)


def decoded(profile, wearer, values=None):
    """Return the in-phase share and the share of the strokes' time with activation, from the tenth second on."""
    activation = activation_of(profile, wearer, values)
    late = wearer.t >= 10.0
    moving = np.roll(wearer.moving, round(0.1 * wearer.rate))
    total = max(activation[late].sum(), 1e-9)
    return activation[moving & late].sum() / total, (activation[moving & late] > 0).mean()


def activation_of(profile, wearer, values=None):
    """Return the activation (n,) by the map from other people."""
    joints = tuple(joint.model_copy(update={"map": "prior"}) for joint in profile.joints)
    parameters = standard_parameters(profile.model_copy(update={"joints": joints}))
    values = (wearer.values if values is None else values).astype(np.float32)
    return decode_block(parameters, wearer.rate, wearer.t, values).activation[:, 0]


@pytest.mark.parametrize("seed", STRANGERS)
@pytest.mark.parametrize("prompts", [0, 3])
def test_somebody_new_drives(prior, seed, prompts):
    wearer = Wearer(seed)
    fit = fitted(wearer, prior, prompts=prompts)
    assert fit.reasons == {}
    assert fit.arrangement == {"cuff": Arrangement()}
    own = fit.profile.joints[0].prior
    assert (own.people, own.repetitions, own.dropped, own.arrangement) == (8, prompts, (), {})
    in_phase, hit = decoded(fit.profile, wearer)
    assert in_phase > 0.93
    assert hit > 0.6
    assert fit.profile.joints[0].map == "pca"  # a person chooses


@pytest.mark.parametrize("shift", range(1, SENSORS))
def test_a_turned_ring_is_found_and_undone(prior, shift):
    wearer = Wearer(102)
    turned = np.roll(wearer.values, shift, axis=1)
    fit = fitted(wearer, prior, turned)
    assert fit.arrangement == fit.profile.joints[0].prior.arrangement == {"cuff": Arrangement(shift=shift)}
    assert decoded(fit.profile, wearer, turned) == pytest.approx(
        decoded(fitted(wearer, prior).profile, wearer), abs=0.01
    )


def test_a_ring_that_somebody_is_sure_of_is_left_as_worn(prior):
    wearer = Wearer(102)
    free = wearer.values[: round(10 * wearer.rate)]
    turned = np.roll(free, 1, axis=1)
    clean = CleanRecording.of(sleeve(), wearer.rate, free=turned)
    sure = with_prior_maps(fit_profile(clean), prior, clean, as_worn=("cuff",)).profile.joints[0].prior
    assert (sure.arrangement, sure.as_worn) == ({}, {"cuff": Arrangement(shift=1)})
    assert sure.model_dump()["as_worn"]
    clean = CleanRecording.of(sleeve(), wearer.rate, free=free)
    right = with_prior_maps(fit_profile(clean), prior, clean, as_worn=("cuff",))
    before = fitted(wearer, prior).profile.joints[0].prior
    assert right.profile.joints[0].prior == before
    assert "as_worn" not in before.model_dump()


def test_a_layout_without_rings_has_no_test():
    layout = sleeve(ring=False)
    prior = MapPrior.of(prior_of(range(1, 5), layout))
    wearer = Wearer(102)
    fit = fitted(wearer, prior, np.roll(wearer.values, 1, axis=1), layout=layout)
    assert fit.arrangement == {}
    assert np.prod(decoded(fit.profile, wearer, np.roll(wearer.values, 1, axis=1))) < 0.5


@pytest.mark.parametrize("seed", STRANGERS)
def test_other_gains_cost_little(prior, seed):
    wearer = Wearer(seed)
    gains = np.random.default_rng(seed).uniform(0.6, 1.7, SENSORS)
    before, after = (
        decoded(fitted(wearer, prior, v).profile, wearer, v) for v in (wearer.values, wearer.values * gains)
    )
    assert np.subtract(after, before).min() > -0.08


@pytest.mark.parametrize("unit", [1e-5, 1e5])
def test_the_unit_of_all_signals_does_not_matter(prior, unit):
    wearer = Wearer(103)
    values = wearer.values * unit
    assert decoded(fitted(wearer, prior, values).profile, wearer, values) == pytest.approx(
        decoded(fitted(wearer, prior).profile, wearer), abs=0.02
    )


@pytest.mark.parametrize("dead", range(SENSORS))
def test_a_channel_that_hardly_moves_is_dropped_and_the_others_drive(prior, dead):
    wearer = Wearer(104)
    values = wearer.values.copy()
    values[:, dead] = values[0, dead] + 0.02 * (values[:, dead] - values[0, dead])
    fit = fitted(wearer, prior, values)
    own = fit.profile.joints[0].prior
    assert f"e{dead}" in own.dropped or f"e{dead}" in fit.profile.left_out
    in_phase, hit = decoded(fit.profile, wearer, values)
    assert in_phase > 0.85
    assert hit > 0.5


def test_before_ten_seconds_the_scale_is_other_people_s(prior):
    wearer = Wearer(105)
    clean = CleanRecording.of(sleeve(), RATE, free=wearer.values[: round(4 * RATE)])
    fit = with_prior_maps(fit_profile(clean), prior, clean)
    assert fit.arrangement == {}
    assert decoded(fit.profile, wearer)[0] > 0.85


def test_three_people_are_too_few():
    wearer = Wearer(101)
    fit = fitted(wearer, MapPrior.of(prior_of([1, 2, 3])))
    assert fit.profile.joints[0].prior is None
    assert "3 of them are known for this joint, and 4 are needed" in str(fit.reasons["right_elbow"])


def test_another_layout_is_refused(prior):
    other = ShirtLayout.model_validate_json(sleeve().model_dump_json().replace("right_elbow", "left_elbow"))
    with pytest.raises(PriorError, match="a prior of its own"):
        fitted(Wearer(101), prior, layout=other)


def test_a_layout_from_before_its_rings_takes_the_map_without_comparing_them(prior):
    fit = fitted(Wearer(101), prior, layout=sleeve(ring=False))
    assert (fit.reasons, fit.arrangement) == ({}, {})
    assert fit.profile.joints[0].prior.arrangement == {}


def test_the_sign_of_the_paper_s_map_follows_other_people_where_nobody_prompted(prior):
    for seed in STRANGERS:
        wearer = Wearer(seed)
        joint = fitted(wearer, prior).profile.joints[0]
        place = (wearer.values[:, joint.channels] - np.array(joint.mean)) @ np.array(joint.direction)
        assert np.corrcoef(place, wearer.angle)[0, 1] > 0.5


def test_forecasts_come_with_their_uncertainty_and_what_is_not_known_is_none(prior):
    wearer = Wearer(106)
    alone, prompted = (fitted(wearer, prior, prompts=count).profile.joints[0].prior for count in (0, 3))
    assert alone.false_per_minute is None
    assert (alone.check, alone.pca_check) == (None, None)
    assert prompted.false_per_minute is not None
    assert prompted.hits.value > 80
    assert 0 < prompted.hits.uncertainty < alone.hits.uncertainty


@pytest.mark.parametrize("prompts", [0, 3])
def test_the_hits_expected_are_movements_that_reach_half_of_full(prior, prompts):
    expected, came = [], []
    for seed in STRANGERS:
        wearer = Wearer(seed)
        profile = fitted(wearer, prior, prompts=prompts).profile
        activation = activation_of(profile, wearer)
        delay = round(0.1 * wearer.rate)
        late = [(start, stop) for start, stop in wearer.strokes if start >= 10 * wearer.rate]
        came.append(100 * np.mean([activation[start : stop + delay].max() >= 0.5 for start, stop in late]))
        expected.append(profile.joints[0].prior.hits.value)
    assert 70.0 < np.mean(expected) < np.mean(came) + 5.0  # people of two garments differ, and it must not flatter


WAVE = np.sin(np.linspace(0.0, 40.0, 4_000))  # free movement whose rate peaks at 1
OF_OTHERS = 3.0


def repetitions(*peaks):
    """Return the held-out rate and the frames of repetitions of 100 rows, each with its peak in the labelled part."""
    rate = np.concatenate([peak * np.sin(np.linspace(0.0, np.pi, 100)) for peak in peaks])
    label = np.tile(np.abs(np.arange(100) - 50) < 40, len(peaks)).astype(np.int8)
    number = np.repeat(np.arange(len(peaks)), 100)
    return rate, OwnFrames(np.zeros((len(rate), 1)), label, number, np.full(len(peaks), 100))


def test_full_is_the_median_peak_of_three_own_repetitions_and_nothing_else():
    peaks = own_peaks(10.0 * WAVE, 0.2, *repetitions(0.8, 1.4, 1.0))
    assert own_full(peaks, 0.2, OF_OTHERS) == pytest.approx(1.0, abs=0.01)


def test_the_free_movement_counts_as_one_repetition_before_there_are_three():
    peaks = own_peaks(WAVE, 0.2, *repetitions(0.6))
    assert own_full(peaks, 0.2, OF_OTHERS) == pytest.approx((0.6 + np.percentile(WAVE, 97)) / 2, abs=0.01)
    assert own_full(own_peaks(WAVE, 0.2, None, None), 0.2, OF_OTHERS) == pytest.approx(np.percentile(WAVE, 97))


def test_a_free_movement_that_never_went_this_way_leaves_other_people_s_full():
    for free in (np.zeros(1_000), -np.ones(1_000), 0.1 * WAVE):
        peaks = own_peaks(free, 0.5, None, None)
        assert own_full(peaks, 0.5, OF_OTHERS) == OF_OTHERS
        assert expected_hits(peaks, 0.5, OF_OTHERS, 0) is None


def test_full_is_clearly_above_the_dead_zone_however_slow_somebody_is():
    assert own_full([0.4, 0.5, 0.6], 0.6, OF_OTHERS) == pytest.approx(LEAST_FULL * 0.6)


def test_a_slow_person_is_expected_to_be_answered_with_the_own_full_and_not_with_that_of_others():
    peaks = [0.9, 1.0, 1.1]
    own, others = (expected_hits(peaks, 0.3, full, 3) for full in (own_full(peaks, 0.3, OF_OTHERS), OF_OTHERS))
    assert own.value > 95.0
    assert others.value < 5.0


def test_more_repetitions_make_the_forecast_surer():
    uncertainties = [expected_hits([1.0], 0.3, 1.0, count).uncertainty for count in range(4)]
    assert uncertainties == sorted(uncertainties, reverse=True)
    assert len(set(uncertainties)) == 4


def test_hits_with_prompts_are_as_many_and_surer() -> None:
    without = Forecast(value=70.0, uncertainty=deviation_of_hits(0))
    prompted = hits_with_prompts(without)
    assert (prompted.value, prompted.uncertainty) == (70.0, deviation_of_hits(3))
    assert prompted.uncertainty < 0.75 * without.uncertainty
