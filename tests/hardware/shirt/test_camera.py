"""The camera: its messages, its steady grid, what is missing, and what is too old."""

import math
import random
from struct import pack

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.camera_page import CHANNELS, CameraPage, message_of
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.calibration.vocabulary import standard_parameters
from app.faults import Fault, State
from app.hardware.configs import SHIRTS
from app.hardware.registry import make_shirt, parse_shirt
from app.hardware.shirt.camera import HEADER, CameraConfig, CameraShirt, decode_sample
from app.hardware.shirt.kind import NOBODY_PROVES_IT
from app.messages import ALIVE
from app.pipeline.loop import ControlLoop
from app.pipeline.setup import Setup
from app.texts import LANGUAGES, reader_language
from building import joint_map, profile_of

RATE = 30.0
PERIOD = 1 / RATE
NOTHING = np.zeros(CHANNELS, np.float32)


@pytest.fixture
def clock():
    return FakeClock(50.0)


@pytest.fixture
def shirt(clock):
    shirt = CameraShirt(CameraConfig(kind="camera"), clock)
    shirt.open()
    return shirt


@pytest.fixture
def page(shirt, clock):
    return CameraPage(shirt, clock)


def frames_of(shirt, clock, seconds):
    """Read for so long, as the loop does."""
    end, frames = clock.now() + seconds, []
    while clock.now() < end - 1e-9:
        frame = shirt.read(min(0.02, end - clock.now()))
        frames += [frame] if frame else []
    return frames


def run(shirt, clock, page, seconds, interval=PERIOD, **underway):
    """Let a page send every `interval` s, and return the frames that came meanwhile."""
    frames = []
    for _ in range(round(seconds / interval)):
        page.send(**underway)
        frames += frames_of(shirt, clock, interval)
    return frames


def is_missing(frame):
    return bool(np.isnan(frame.values).all())


def test_a_steady_page_gives_a_frame_for_each_sample(shirt, clock, page):
    frames = run(shirt, clock, page, 20.0)
    assert len(frames) == pytest.approx(600, abs=1)
    assert [frame.seq for frame in frames] == list(range(len(frames)))
    np.testing.assert_allclose(np.diff([frame.t_device for frame in frames]), PERIOD)
    np.testing.assert_allclose(np.diff([frame.t for frame in frames]), PERIOD, atol=1e-9)
    assert not any(map(is_missing, frames))
    numbers = [round(float(frame.values[0]) * 1000) for frame in frames]
    assert numbers == sorted(numbers)
    assert (shirt.lost, shirt.refused, shirt.late) == (0, 0, 0)
    assert "19 sensors, 30 pictures a second, each 20 ms old when it arrives" in str(shirt.description())


@pytest.mark.parametrize("rate", [12, 24, 47])
def test_another_rate_of_pictures_is_put_on_the_grid_by_the_newest_sample(shirt, clock, page, rate):
    frames = run(shirt, clock, page, 10.0, 1 / rate)
    assert len(frames) == pytest.approx(300, abs=2)
    assert not any(map(is_missing, frames))
    assert {float(frame.values[0]) for frame in frames} <= {np.float32(i / 1000) for i in range(1000)}
    assert f"{rate} pictures a second" in str(shirt.description())


def test_jitter_adds_and_loses_no_frame(shirt, clock, page):
    chance = random.Random(1)
    frames = []
    for _ in range(900):
        page.send(underway=chance.uniform(0.0, 0.02))
        frames += frames_of(shirt, clock, chance.uniform(0.5, 1.5) * PERIOD)
    assert np.diff([frame.seq for frame in frames]).tolist() == [1] * (len(frames) - 1)
    assert not any(map(is_missing, frames))
    assert shirt.lost == 0


def test_a_camera_that_hangs_is_found_and_a_slow_one_is_no_broken_one(clock):
    shirt = CameraShirt(CameraConfig(kind="camera", sample_rate=10.0), clock)
    shirt.open()
    page = CameraPage(shirt, clock)
    assert all(shirt.layout.may_stay_constant)
    assert not any(map(is_missing, run(shirt, clock, page, 2.0, 0.14)))
    frozen = np.full(CHANNELS, 0.1, np.float32)
    page.send(frozen)
    frames = []
    for _ in range(5):
        frames += frames_of(shirt, clock, 0.1)
        page.send(frozen)
    assert is_missing(frames[-1])
    assert shirt.read(0.1) is None


def test_what_is_not_visible_is_missing_in_the_next_frame(shirt, clock, page):
    values = np.arange(CHANNELS, dtype=np.float32) / 100
    values[3:6] = np.nan
    page.send(values)
    frame = shirt.read(0.1)
    np.testing.assert_array_equal(frame.values, values)
    page.send(np.full(CHANNELS, np.nan, np.float32))
    clock.time += PERIOD
    assert is_missing(shirt.read(0.1))
    assert "sees nobody" in str(shirt.description())


def test_after_three_periods_without_a_sample_every_channel_is_missing_then_the_shirt_is_silent(shirt, clock, page):
    run(shirt, clock, page, 1.0)
    since = clock.now() - PERIOD  # of the last sample
    frames = frames_of(shirt, clock, 3.0 + PERIOD / 2)  # from the middle between two frames on
    assert [is_missing(frame) for frame in frames] == [frame.t - since > 3 * PERIOD for frame in frames]
    assert frames[-1].t - since <= ALIVE < frames[-1].t - since + 2 * PERIOD
    assert not shirt.pending()
    assert str(shirt.description()).startswith("No camera sends: start it on the Shirt page")
    page.send()
    (again,) = frames_of(shirt, clock, PERIOD)
    assert not is_missing(again)
    assert again.t_device - frames[-1].t_device == pytest.approx(again.t - frames[-1].t, abs=PERIOD)
    assert shirt.lost == again.seq - frames[-1].seq - 1


def test_the_age_of_a_picture_is_known_whatever_the_clock_of_the_page_says(shirt, clock, page):
    page.reading, page.ahead = 0.11, 123_456.0
    run(shirt, clock, page, 2.0)
    assert "each 110 ms old" in str(shirt.description())
    run(shirt, clock, page, 0.1, underway=0.2)
    assert "each 310 ms old" in str(shirt.description())


@pytest.mark.parametrize("drift", [-1e-4, 1e-4])
def test_a_clock_that_drifts_makes_no_picture_old(shirt, clock, page, drift):
    page.drift = drift
    run(shirt, clock, page, 100.0, 0.1)
    assert "each 20 ms old" in str(shirt.description())
    assert shirt.late == 0


def test_a_picture_of_the_past_counts_as_none(shirt, clock, page):
    run(shirt, clock, page, 1.0)
    frames = run(shirt, clock, page, 2.0, underway=0.6)
    assert shirt.late == 60
    assert [is_missing(frame) for frame in frames[4:]] == [True] * (len(frames) - 4)
    assert "its pictures arrived 0.6 s late" in str(shirt.description())
    assert not any(map(is_missing, run(shirt, clock, page, 1.0)))  # in time again


def test_a_backlog_shows_only_its_newest_sample(shirt, clock, page):
    run(shirt, clock, page, 1.0)
    for i in range(9, -1, -1):
        page.send(underway=i * PERIOD)
    newest = frames_of(shirt, clock, PERIOD)[-1]
    assert round(float(newest.values[0]) * 1000) == page.seq - 1
    assert shirt.late == 0


def test_what_comes_again_or_is_older_counts_for_nothing(shirt, clock, page):
    first, second = page.message(), page.message()
    page.deliver(second)
    for message in (second, first):
        page.deliver(message)
    assert shirt.refused == 2
    assert float(shirt.read(0.1).values[0]) == np.float32(0.001)
    assert "2 messages refused" in str(shirt.description())


def test_another_page_begins_anew(shirt, clock, page):
    run(shirt, clock, page, 2.0)
    frames_of(shirt, clock, 3.0)
    other = CameraPage(shirt, clock, number=2)
    other.ahead = 3.0
    frames = run(shirt, clock, other, 1.0)
    assert not any(map(is_missing, frames))
    assert (shirt.refused, shirt.late) == (0, 0)
    assert "each 20 ms old" in str(shirt.description())


def test_each_message_that_is_no_sample_is_refused(shirt, clock, page):
    good = message_of(7, 1.0, 1.5, NOTHING)
    assert decode_sample(good, CHANNELS) is not None
    wrong = {
        "empty": b"",
        "short": good[:-1],
        "long": good + b"\0",
        "another version": b"\2" + good[1:],
        "not zero": good[:1] + b"\1" + good[2:],
        "another count": message_of(7, 1.0, 1.5, NOTHING[:-1]) + bytes(4),
        "another layout": message_of(7, 1.0, 1.5, NOTHING[:3]),
        "sent before the picture": message_of(7, 2.0, 1.5, NOTHING),
        "a time before the page": message_of(7, -1.0, 1.5, NOTHING),
        "no time": message_of(7, math.nan, 1.5, NOTHING),
        "no time of sending": message_of(7, 1.0, math.nan, NOTHING),
        "an endless time": message_of(7, 1.0, math.inf, NOTHING),
        "a picture read for an hour": message_of(7, 1.0, 3601.0, NOTHING),
        "an endless value": message_of(7, 1.0, 1.5, np.full(CHANNELS, np.inf, np.float32)),
        "an impossible value": message_of(7, 1.0, 1.5, np.full(CHANNELS, -10.5, np.float32)),
    }
    for message in wrong.values():
        page.deliver(message)
    assert {name: decode_sample(message, CHANNELS) for name, message in wrong.items()} == dict.fromkeys(wrong)
    assert shirt.refused == len(wrong)
    assert frames_of(shirt, clock, 0.2) == []


@given(st.binary(max_size=HEADER.size + 4 * CHANNELS + 8))
@settings(max_examples=300, deadline=None)
def test_any_bytes_are_a_sample_of_possible_numbers_or_nothing(junk):
    sample = decode_sample(junk, CHANNELS)
    assert sample is None or np.all(np.isnan(sample.values) | (np.abs(sample.values) <= 10.0))


@given(
    st.integers(0, 2**32 - 1),
    st.floats(0, 1e6),
    st.floats(0, 50),
    st.lists(st.floats(-10, 10, width=32) | st.just(math.nan), min_size=CHANNELS, max_size=CHANNELS),
)
@settings(max_examples=100, deadline=None)
def test_a_sample_comes_as_it_was_sent(seq, picture_t, reading, values):
    sent = np.array(values, np.float32)
    sample = decode_sample(message_of(seq, picture_t, picture_t + reading, sent), CHANNELS)
    assert sample is not None
    assert sample[:3] == (seq, picture_t, picture_t + reading)
    np.testing.assert_array_equal(sample.values, sent)


def test_junk_and_silence_of_a_closed_camera_change_nothing(shirt, clock, page):
    for i in range(2000):
        page.deliver(pack("<I", i) * (i % 40))
    assert (shirt.refused, frames_of(shirt, clock, 0.1)) == (2000, [])
    shirt.close()
    page.send()
    assert frames_of(shirt, clock, 0.1) == []
    assert str(shirt.description()) == "The camera is not in use."


@pytest.fixture
def driving(clock, ring):
    """A loop whose virtual chair is armed, its camera's page, and a function that lets the page send for so long."""
    setup = Setup(clock)
    change = setup.change_shirt(parse_shirt({"kind": "camera"}))
    change.use(change.open())
    layout = setup.shirt.layout
    maps = [
        joint_map(joint, channels, (1.0,) + (0.0,) * (len(channels) - 1))
        for joint, channels in layout.channels_of_joint.items()
    ]
    setup.use_parameters(standard_parameters(profile_of(layout, maps, -10.0, 10.0, RATE)))
    loop, page, chance = ControlLoop(setup, ring, None, clock), CameraPage(setup.shirt, clock), random.Random(1)

    def go(seconds, make=lambda: np.array([chance.gauss(0.0, 1e-3) for _ in range(CHANNELS)], np.float32)):
        """`make` returns the values of a sample; None: the page is gone."""
        end = clock.time + seconds
        while clock.time < end - 1e-9:
            if make is not None:
                page.send(make())
            until = clock.time + PERIOD
            while clock.time < until - 1e-9:
                loop.last_heartbeat = loop.last_screen_report = clock.time
                loop.turn()

    go(0.2)
    assert setup.chain.arm()
    go(2.0)
    assert setup.chain.gate.state is State.ARMED
    yield loop, go
    setup.close()


def test_a_lost_person_stops_the_chair(driving):
    loop, go = driving
    go(0.3, lambda: np.full(CHANNELS, np.nan, np.float32))
    assert loop.setup.chain.gate.state is State.FAULT
    assert loop.setup.chain.gate.fault in {Fault.CHANNELS_BAD, Fault.BRAKE_BAD}
    assert loop.shirt_alive


def test_a_page_that_is_gone_stops_the_chair(driving):
    loop, go = driving
    go(0.4, None)
    assert loop.setup.chain.gate.state is State.FAULT
    go(0.7, None)
    assert loop.shirt_silent


def test_the_ticks_have_the_channels_and_a_camera_arms_no_real_chair(driving, ring):
    loop, _ = driving
    setup = loop.setup
    assert (setup.source.shirt, setup.source.simulated, setup.mistrust) == ("camera", False, NOBODY_PROVES_IT)
    ticks, _ = ring.since(0)
    seen = ticks[ticks["has_frame"] == 1]
    assert len(seen) == pytest.approx(2.2 * RATE, abs=2)
    assert set(seen["n_channels"]) == {CHANNELS}
    assert not np.isnan(seen["values"][:, :CHANNELS]).any()


def test_its_form_has_a_rate_and_its_texts_are_in_every_language():
    kind = SHIRTS["camera"]
    for language in LANGUAGES:
        with reader_language(language):
            schema = kind.config.model_json_schema()
            assert set(schema["properties"]) == {"kind", "sample_rate"}
            shirt = make_shirt(CameraConfig(kind="camera"), FakeClock())
            shirt.open()
            assert str(shirt.description()).endswith(".")
    with pytest.raises(ValidationError):
        CameraConfig(kind="camera", sample_rate=5.0)
    assert kind.mistrust(CameraConfig(kind="camera")) == NOBODY_PROVES_IT
