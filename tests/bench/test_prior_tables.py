"""The bench of the prior: what it calls movement and hits, and the network that is tried beside the linear map."""

import ast
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_prior_maps
from app.calibration.prior.solving import OwnFrames
from bench.prior.__main__ import CHANGES, Comparison, entries_of
from bench.prior.network import LINEAR, MEAN, Network, activation, is_better, verdict
from bench.prior.simulated import simulated_people
from bench.prior.wearers import Figures, figures, movement_of, summary
from folders import ROOT


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


def person(seed: int) -> Any:
    """Return 4000 frames of a label that depends on the size of a feature, whatever its sign."""
    inputs = np.random.default_rng(seed).normal(size=(4000, 2))
    label = (np.abs(inputs[:, 0]) > 1.0).astype(np.int8)
    return SimpleNamespace(frames=OwnFrames(inputs, label, np.zeros(4000, np.int_), np.array([4000])))


def test_the_network_learns_what_a_line_cannot() -> None:
    network = Network([person(1), person(2)], np.zeros(2))
    other = person(3).frames
    rate = network.rate(other.features)
    assert np.corrcoef(rate, other.label)[0, 1] > 0.6  # a line has none
    assert 0.0 < network.dead_zone < network.full


def test_an_activation_begins_at_the_dead_zone_and_ends_at_full() -> None:
    np.testing.assert_allclose(activation(np.array([-1.0, 1.0, 1.5, 2.0, 9.0]), 2.0), [0, 0, 0.5, 1, 1])


def test_a_network_is_worth_its_place_for_a_gain_or_for_half_the_false_activations() -> None:
    def people(in_phase: float, false: float) -> list[Figures]:
        return [Figures(in_phase, 0.9, 0.7, false)] * 10

    alone = people(0.95, 2.0)
    assert not is_better(alone, alone)
    assert not is_better(alone, people(0.955, 1.2))
    assert is_better(alone, people(0.961, 2.0))
    assert is_better(alone, people(0.95, 1.0))
    assert not is_better(people(1.0, 0.0), people(1.0, 0.0))


def test_no_module_imports_a_program() -> None:
    """What a command and another one share lies in a module, which can be imported without the command."""
    programs = []
    for file in sorted((ROOT / "bench").rglob("*.py")):
        imports = [node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.ImportFrom)]
        programs += [file.name for node in imports if (node.module or "").endswith("__main__")]
    assert programs == []


def test_the_summary_names_both_maps_and_says_when_a_network_would_be_offered() -> None:
    alone, better = [Figures(0.95, 0.9, 0.7, 2.0)] * 10, [Figures(0.97, 0.9, 0.7, 2.0)] * 10
    same, gain = ({(5.0, LINEAR): alone, (5.0, MEAN): other} for other in (alone, better))
    assert verdict(same) == "A network would be offered after no amount of own prompts."
    assert verdict(gain) == "A network would be offered after own prompts of 5 s."
