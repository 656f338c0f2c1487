"""The bench of the prior: what it calls movement and hits, on one recording whose truth is known."""

import numpy as np
import pytest

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_prior_maps
from bench.prior.__main__ import CHANGES, Comparison, entries_of
from bench.prior.simulated import simulated_people
from bench.prior.wearers import figures, movement_of, summary


def test_movement_is_what_the_place_does() -> None:
    t = np.arange(1000) / 100.0
    place = 5.0 * (0.5 - 0.5 * np.cos(np.pi * np.clip(t - 3.0, 0.0, 1.0)))
    movement = movement_of(place, 100.0)
    assert len(movement.strokes) == 1
    start, stop = movement.strokes[0]
    assert (start / 100, stop / 100) == pytest.approx((3.15, 4.05), abs=0.1)
    assert movement.still[:250].all()
    assert movement.still[500:].all()
    assert not movement.still[start:stop].any()


def test_simulated_people_are_decoded_by_each_other_s_map() -> None:
    people = simulated_people(5, ("right_elbow",))
    entries = entries_of(people)
    comparison = Comparison(people, entries)
    assert all(comparison.arrangements(people[0], 0))
    assert all(comparison.arrangements(people[0], 1))
    for change in CHANGES.values():
        wearer = change(people[0])
        prior = MapPrior.of(comparison.prior_without(people[0].group))
        free = wearer.values[wearer.free]
        clean = CleanRecording.of(wearer.layout, wearer.sample_rate, free)
        fitted = with_prior_maps(fit_profile(clean), prior, clean)
        found = figures(wearer, wearer.parts[0], fitted.profile, "prior")
        assert found.in_phase > 0.95
        assert found.active > 0.4
        assert "1.000" in summary([found]) or "0.9" in summary([found])
