"""A recording is checked, its channels are chosen and its gaps are filled once, for every fit."""

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, layout_of

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.repetitions import Stretch

LAYOUT = layout_of()


def test_every_piece_is_without_gaps_and_a_channel_with_too_many_is_left_out():
    person = SimulatedPerson(LAYOUT)
    free, rest, repetitions = person.free(), person.rest(), person.repetitions()
    free[100:105, 1] = np.nan
    free[:, 3] = np.nan
    stretch = Stretch("right_elbow", free[50:150], (slice(10, 60),))
    clean = CleanRecording.of(LAYOUT, 100.0, free, rest, repetitions, [stretch])
    pieces = [clean.free, clean.rest, *(one.values for one in (*clean.repetitions, *clean.stretches))]
    assert all(np.isfinite(piece).all() for piece in pieces)
    np.testing.assert_array_equal(np.diff(clean.free[99:106, 1], n=2), pytest.approx(0.0, abs=1e-9))
    assert list(clean.left_out) == [LAYOUT.channel_names[3]]
    assert np.isnan(free[100:105, 1]).all(), "the recording itself stays as it was"


def test_the_pieces_of_a_joint_are_found_by_its_name_and_prompts_can_be_cut_anew():
    person = SimulatedPerson(LAYOUT)
    clean = CleanRecording.of(LAYOUT, 100.0, person.free(), None, person.repetitions())
    assert {one.joint for one in clean.repetitions_of("left_elbow")} == {"left_elbow"}
    assert clean.stretches_of("left_elbow") == []
    values = person.free()
    values[7, 0] = np.nan
    again = clean.with_stretches([Stretch("left_elbow", values, (slice(0, 50),))])
    assert np.isfinite(again.stretches_of("left_elbow")[0].values).all()
    assert again.left_out is clean.left_out
