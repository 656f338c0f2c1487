"""A recorded knit that is streamed over LSL: calibrated and decoded as the file is, on a stand-in and on pylsl itself.

Nothing depends on how quickly it is sent: its time stamps are those of the recording.
"""

import re

import numpy as np
import pytest
from calibration.test_knit_shirt import rises
from fake_clock import FakeClock
from hardware.shirt.lsl_networks import ANSWER, networks

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import repetitions_of_prompts
from app.calibration.vocabulary import standard_parameters
from app.hardware.shirt import stream_join
from app.hardware.shirt.lsl import LslConfig, LslShirt
from app.pipeline.replay.batch import decode_block
from app.signals.signals import read_signals
from bench.learning.guided_map import FOLDER, LAYOUT

SAME = 1e-6
APART = 1e-3  # s, by which LSL takes the clocks of sender and receiver for different
PART = 500  # frames that are sent before they are read
CALIBRATION = 20.0  # s
DECODED = ("score", "rate", "drive", "activation", "u1", "u2", "v", "omega", "x", "y", "theta")

needs_knit = pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")
network = pytest.fixture(scope="module", name="network")(networks)


def shirt_on(net, **fields):
    return LslShirt(LslConfig(kind="lsl", **fields), net.clock, lambda: net.lsl)


def next_frame(net, shirt):
    """Return the next frame, however busy the machine is; nobody waits on the fake clock."""
    if isinstance(net.clock, FakeClock):
        return shirt.read(0.1)
    until = net.clock.now() + ANSWER
    while net.clock.now() < until:
        if (frame := shirt.read(0.1)) is not None:
            return frame
    raise AssertionError("no frame came")


def streamed(net, recorded, parts):
    """Send the channels of a recording as one stream for each part, and return the frames of the shirt."""
    names = LAYOUT.channel_names
    senders = [
        net.add(f"Knit {i} of {len(parts)}", f"knit-{i}-{len(parts)}", names[part], recorded.sample_rate)
        for i, part in enumerate(parts)
    ]
    shirt = shirt_on(net, source_id=",".join(f"knit-{i}-{len(parts)}" for i in range(len(parts))))
    shirt.open()
    assert shirt.layout.channels == LAYOUT.channels
    assert shirt.sample_rate == recorded.sample_rate
    for sender in senders:
        sender.wait_for_receiver()
    start = net.lsl.local_clock() - recorded.t[0]
    frames = []
    for first in range(0, len(recorded.t), PART):
        rows = slice(first, first + PART)
        for sender, part in zip(senders, parts, strict=True):
            sender.push(start + recorded.t[rows], recorded.values[rows, part])
        frames += [next_frame(net, shirt) for _ in recorded.t[rows]]
    assert shirt.lost == 0
    shirt.close()
    for sender in senders:
        sender.end()
    return np.array([frame.t_device for frame in frames]) - start, np.array([frame.values for frame in frames])


def calibrated(t, values, rate, rows):
    free = values[t - t[0] < CALIBRATION]
    seen = [row for row in rows if row.end < CALIBRATION]
    repetitions = repetitions_of_prompts(t, values, seen, rate)
    return fit_profile(CleanRecording.of(LAYOUT, rate, free=free, repetitions=repetitions))


@needs_knit
@pytest.mark.parametrize("parts", [[slice(0, 20)], [slice(0, 7), slice(7, 20)]], ids=["one-stream", "two-streams"])
@pytest.mark.parametrize("where", ["stand-in", "pylsl"])
def test_a_knit_over_lsl_is_calibrated_and_decoded_as_the_file(network, monkeypatch, where, parts):
    for limit in ("PATIENCE", "ALIVE"):  # a busy machine brings one stream later than the other
        monkeypatch.setattr(stream_join, limit, ANSWER)
    recorded = read_signals(FOLDER / "signals.csv", LAYOUT)
    file, rate = recorded.values.astype(np.float32), recorded.sample_rate
    t, values = streamed(network(where), recorded, parts)
    np.testing.assert_array_equal(values, file)
    assert abs(t[0] - recorded.t[0]) < APART
    t = np.round(t + recorded.t[0] - t[0], 6)  # a rounding error would move a frame over the border of a repetition
    np.testing.assert_allclose(t, recorded.t, atol=SAME)
    rows = rises(rate)
    of_file = calibrated(recorded.t, file.astype(np.float64), rate, rows)
    of_stream = calibrated(t, values.astype(np.float64), rate, rows)
    for one, other in zip(of_file.joints, of_stream.joints, strict=True):
        np.testing.assert_allclose(other.direction, one.direction, atol=SAME)
        np.testing.assert_allclose(other.mean, one.mean, atol=SAME)
        assert other.span == pytest.approx(one.span, abs=SAME)
        assert other.thresholds == pytest.approx(one.thresholds, abs=SAME)
    parameters = standard_parameters(of_stream)
    expected = decode_block(standard_parameters(of_file), rate, recorded.t, file)
    found = decode_block(parameters, rate, t, values)
    assert np.ptp(expected.activation) == 1.0
    for name in DECODED:
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), atol=SAME, err_msg=name)


@pytest.mark.parametrize("where", ["stand-in", "pylsl"])
def test_a_sender_that_is_started_again_is_received_again(network, where):
    net = network(where)
    first = net.add("Arm", "arm-again", ["a", "b"], 100.0)
    shirt = shirt_on(net, source_id="arm-again")
    shirt.open()
    first.wait_for_receiver()
    start = net.lsl.local_clock()
    first.push([start], np.array([[1.0, 2.0]]))
    assert next_frame(net, shirt).values.tolist() == [1, 2]
    first.end()
    until = net.clock.now() + ANSWER
    while not shirt._streams[0].is_lost and net.clock.now() < until:
        shirt.read(0.05)
    again = net.add("Arm", "arm-again", ["a", "b"], 100.0)
    while shirt._streams[0].is_lost and net.clock.now() < until:
        shirt.read(0.05)
        if shirt._streams[0]._search is not None:
            shirt._streams[0]._search.join(ANSWER)
    again.wait_for_receiver()
    again.push([start + 1.0], np.array([[3.0, 4.0]]))
    frame = next_frame(net, shirt)
    assert (frame.seq, frame.values.tolist(), shirt.lost) == (100, [3, 4], 99)
    shirt.close()
    again.end()


def test_the_time_stamps_of_a_sender_become_the_age_of_its_samples(network):
    """On one machine both clocks are one: the age is that of the time stamps."""
    net = network("pylsl")
    sender = net.add("Old", "old", ["a"], 100.0)
    shirt = shirt_on(net, source_id="old")
    shirt.open()
    sender.wait_for_receiver()
    sender.push([net.lsl.local_clock() - 5.0], np.array([[1.0]]))
    next_frame(net, shirt)
    said = re.search(r" at 100 Hz, ([\d,]+) ms old", str(shirt.description()))
    assert int(said[1].replace(",", "")) >= 4_999
    shirt.close()
    sender.end()
