"""The shirt over LSL, on a network without a network: clocks, jitter, loss, recovery, two senders."""

import importlib
import sys

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.fake_lsl import FakeLsl
from hardware.shirt.shirts import small_layout

from app.hardware.base import HardwareError
from app.hardware.shirt.lsl import LslConfig, LslShirt
from app.hardware.shirt.stream_join import PATIENCE
from app.layout import ShirtLayout
from app.lsl_library import load_lsl, lsl_ahead
from app.texts import LANGUAGES, from_document, reader_language, to_document

PERIOD = 0.01  # s
FOUND = 20.0  # s, long enough for a thread that finds a stream at once


@pytest.fixture
def lsl():
    return FakeLsl(FakeClock(50.0))


def shirt_of(lsl, **fields):
    return LslShirt(LslConfig(kind="lsl", **fields), lsl.clock, lambda: lsl)


def opened(lsl, **fields):
    shirt = shirt_of(lsl, **fields)
    shirt.open()
    return shirt


def read_all(shirt, timeout=0.0):
    found = []
    while (frame := shirt.read(timeout)) is not None:
        found.append(frame)
    return found


def let_search_end(shirt):
    for stream in shirt._streams:
        stream._search.join(FOUND)


def test_a_single_stream_passes_through_with_the_times_of_its_sender(lsl):
    sender = lsl.add_sender(clock_ahead=-123.0)
    shirt = opened(lsl)
    start = lsl.clock.now()
    for i in range(200):
        sender.send([i, i / 7, -i], start + i * PERIOD, late=0.004)
    frames = read_all(shirt, 0.02)
    assert [frame.seq for frame in frames] == list(range(200))
    np.testing.assert_array_equal([frame.values for frame in frames], np.float32([[i, i / 7, -i] for i in range(200)]))
    times = start + np.arange(200) * PERIOD
    np.testing.assert_allclose([frame.t_device for frame in frames], times + lsl.offset, atol=1e-6)
    np.testing.assert_allclose([frame.t for frame in frames], times + 0.004, atol=1e-6)
    assert str(shirt.description()) == "LSL streams, 3 sensors at 100 Hz, 24 ms old."  # 20 ms since the last frame


def test_two_streams_whose_clocks_differ_are_joined_by_their_true_times(lsl):
    one = lsl.add_sender("Arm", 2, labels=("a_1", "a_2"), clock_ahead=700.0)
    two = lsl.add_sender("Leg", 1, source_id="leg", labels=("b_1",), clock_ahead=-90.0)
    shirt = opened(lsl, name="Leg,Arm")
    assert shirt.layout.channel_names == ["b_1", "a_1", "a_2"]
    start = lsl.clock.now()
    for i in range(100):
        one.send([i, -i], start + i * PERIOD, late=0.001)
        two.send([1000 + i], start + i * PERIOD, late=0.009)
    frames = read_all(shirt, 0.02)
    assert len(frames) == 100
    np.testing.assert_array_equal([frame.values for frame in frames], [[1000 + i, i, -i] for i in range(100)])


def test_a_slow_drift_of_a_senders_clock_is_followed(lsl):
    steady = lsl.add_sender("Arm", 1, source_id="a")
    drifting = lsl.add_sender("Leg", 1, source_id="b", clock_ahead=3.0, drift=2e-4)
    shirt = opened(lsl, source_id="a,b")
    frames = []
    for i in range(6000):  # a minute: 12 ms of drift, more than a period
        steady.send([i])
        drifting.send([i])
        frames += read_all(shirt)
        lsl.clock.time += PERIOD
    values = np.array([frame.values for frame in frames])
    assert len(frames) == 6000
    assert shirt.lost == 0
    np.testing.assert_array_equal(values[:, 0], values[:, 1])


def test_jitter_and_bursts_lose_and_repeat_nothing(lsl):
    dice = np.random.default_rng(3)
    sender = lsl.add_sender(channels=1)
    shirt = opened(lsl)
    start = lsl.clock.now()
    for i in range(1000):
        t = start + (i // 4 * 4 + 3) * PERIOD  # four samples at once, stamped when they are sent
        sender.send([i], t, late=0.0, stamp=t + lsl.offset + dice.uniform(0.0, 0.002))
    frames = read_all(shirt, 0.05)
    assert [frame.values[0] for frame in frames] == list(range(1000))
    assert [frame.seq for frame in frames] == list(range(1000))
    steps = np.diff([frame.t_device for frame in frames])
    assert steps.min() > 0.5 * PERIOD
    assert steps.max() < 1.5 * PERIOD


def test_what_the_sender_lost_is_a_gap(lsl):
    sender = lsl.add_sender(channels=1)
    shirt = opened(lsl)
    start = lsl.clock.now()
    for i in [*range(20), *range(23, 40)]:
        sender.send([i], start + i * PERIOD)
    frames = read_all(shirt, 0.05)
    assert [frame.seq for frame in frames] == [*range(20), *range(23, 40)]
    assert shirt.lost == 3
    assert ", 3 frames lost" in str(shirt.description())


def test_streams_without_a_rate_come_on_the_grid_of_the_configuration(lsl):
    sender = lsl.add_sender("Bend", 2, 0.0, clock_ahead=44.0)
    shirt = opened(lsl, sample_rate=40.0)
    assert shirt.sample_rate == 40.0
    start = lsl.clock.now()
    for t, value in ((0.0, 1), (0.011, 2), (0.018, 3), (0.06, 4)):
        sender.send([value, -value], start + t)
    frames = read_all(shirt, 0.05)
    assert [frame.values[0] for frame in frames] == [1, 3, 3, 4, 4, 4]
    np.testing.assert_allclose(np.diff([frame.t_device for frame in frames]), 0.025, atol=1e-6)
    assert [frame.seq for frame in frames] == list(range(6))
    assert not shirt.pending()


def test_a_channel_without_a_sample_for_three_periods_is_nan(lsl):
    one = lsl.add_sender("Arm", 1, source_id="a")
    two = lsl.add_sender("Leg", 1, 50.0, source_id="b")
    shirt = opened(lsl, source_id="a,b")
    start = lsl.clock.now()
    two.send([7], start)
    for i in range(20):
        one.send([i], start + i * PERIOD)
    frames = read_all(shirt, 2 * PATIENCE)
    assert [bool(np.isnan(frame.values[1])) for frame in frames] == [i > 6 for i in range(20)]
    assert [frame.values[0] for frame in frames] == list(range(20))


def test_a_stream_that_ends_is_silent_and_its_next_start_goes_on(lsl):
    sender = lsl.add_sender(channels=1, clock_ahead=20.0)
    shirt = opened(lsl)
    sender.send([1])
    assert shirt.read(0.02).values[0] == 1
    sender.end()
    assert shirt.read(0.02) is None
    assert shirt._streams[0].is_lost
    lsl.clock.time += 3.0
    assert shirt.read(0.02) is None
    assert str(shirt.description()) == "No samples from Arm (source ID arm-1, type MoCap, computer lab)."
    again = lsl.add_sender(channels=1, clock_ahead=-7.0)  # by another clock
    let_search_end(shirt)
    assert shirt.read(0.02) is None
    again.send([2])
    frame = shirt.read(0.02)
    assert frame.values[0] == 2
    assert frame.seq == round((lsl.clock.now() - 51.0) / PERIOD)
    assert shirt.lost == frame.seq - 1
    assert shirt._streams[0]._search is None


def test_a_lost_stream_of_several_is_named_while_the_leader_goes_on(lsl):
    one = lsl.add_sender("Arm", 1, source_id="a")
    two = lsl.add_sender("Leg", 1, source_id="b")
    shirt = opened(lsl, source_id="a,b")
    two.send([5])
    two.end()
    for _ in range(20):
        one.send([1])
        lsl.clock.time += PERIOD
        shirt.read(0.0)
    assert "; nothing more comes from Leg (source ID b" in str(shirt.description())
    shirt.close()


@pytest.mark.parametrize("other", [{"host": "elsewhere"}, {"source_id": "arm-2"}, {"channels": 2}])
def test_another_stream_never_takes_the_place_of_a_lost_one(lsl, other):
    sender = lsl.add_sender(channels=1)
    shirt = opened(lsl)
    sender.end()
    lsl.add_sender(**({"channels": 1} | other))
    assert shirt.read(0.0) is None
    search = shirt._streams[0]._search
    search.join(0.2)
    assert search.is_alive()
    shirt.close()
    search.join(FOUND)
    assert not search.is_alive()


def test_a_stream_that_falls_silent_without_an_end_is_looked_for(lsl):
    sender = lsl.add_sender(channels=1)
    shirt = opened(lsl)
    sender.send([1])
    assert shirt.read(0.02) is not None
    lsl.clock.time += 1.9
    assert shirt.read(0.0) is None
    assert shirt._streams[0]._search is None
    lsl.clock.time += 0.2
    assert shirt.read(0.0) is None
    assert shirt._streams[0]._search is not None
    sender.send([2])
    assert shirt.read(0.02).values[0] == 2
    assert shirt.read(0.0) is None
    assert shirt._streams[0]._search is None
    lsl.clock.time += 2.1
    lsl.senders.remove(sender)  # its computer was switched off
    again = lsl.add_sender(channels=1)
    assert shirt.read(0.0) is None
    let_search_end(shirt)
    assert shirt.read(0.0) is None
    again.send([3])
    assert shirt.read(0.02).values[0] == 3


def test_two_streams_of_one_name_are_refused_with_how_to_choose(lsl):
    lsl.add_sender(source_id="arm-1")
    lsl.add_sender(source_id="arm-2")
    with pytest.raises(HardwareError, match="2 LSL streams fit, such as Arm"):
        shirt_of(lsl, name="Arm").open()
    assert len(opened(lsl, name="Arm", source_id="arm-2").layout.channels) == 3
    assert len(opened(lsl, source_id="arm-2,arm-1").layout.channels) == 6


def test_the_leader_is_the_fastest_regular_stream(lsl):
    lsl.add_sender("Slow", 1, 25.0, source_id="a")
    lsl.add_sender("Fast", 1, 250.0, source_id="b")
    lsl.add_sender("Events", 1, 0.0, source_id="c")
    assert opened(lsl, source_id="a,b,c").sample_rate == 250.0


@pytest.mark.parametrize("rate", [5.0, 2001.0, 44_100.0])
def test_a_rate_that_no_shirt_has_is_refused(lsl, rate):
    lsl.add_sender(rate=rate)
    with pytest.raises(HardwareError, match=f"has {rate:g} samples a second, 10 to 2000".replace("44100", "44,?100")):
        shirt_of(lsl).open()


def test_a_layout_that_was_brought_counts_and_must_fit(lsl):
    lsl.add_sender(channels=3, labels=("x", "y", "z"))
    assert opened(lsl, layout=small_layout()).layout == small_layout()
    two = small_layout().model_dump(mode="json")
    del two["channels"][0]
    with pytest.raises(HardwareError, match="have 3 channels and the layout 2"):
        shirt_of(lsl, layout=ShirtLayout.model_validate(two)).open()


def test_a_stream_that_does_not_answer_is_one_sentence_and_leaves_nothing_open(lsl):
    sender = lsl.add_sender()
    sender.answers = False
    shirt = shirt_of(lsl)
    before = lsl.clock.now()
    with pytest.raises(HardwareError, match=r"the LSL stream Arm \(.*\) does not answer: permit UDP and TCP"):
        shirt.open()
    assert lsl.clock.now() - before < 8.0, "the time that an opening has"
    assert str(shirt.description()) == "No LSL stream is open."


def test_liblsl_itself_neither_recovers_nor_gathers_samples(lsl):
    sender = lsl.add_sender()
    opened(lsl)
    options = sender.inlets[0].options
    assert (options["recover"], options["max_chunklen"]) == (False, 1)


def test_a_time_stamp_that_is_no_time_is_left_out_and_a_value_is_passed_on(lsl):
    sender = lsl.add_sender(channels=2)
    shirt = opened(lsl)
    for stamp in ("inf", "nan", "1e308", "-1e300"):
        sender.send([1, 2], stamp=float(stamp))
    sender.send([float("nan"), 1e300])
    (frame,) = read_all(shirt)
    np.testing.assert_array_equal(frame.values, np.float32([np.nan, np.inf]))


def test_closing_ends_what_was_open(lsl):
    lsl.add_sender(channels=1)
    shirt = opened(lsl)
    shirt.close()
    shirt.close()
    assert not shirt.pending()
    assert shirt.lost == 0


@pytest.mark.parametrize("language", LANGUAGES)
def test_its_state_is_said_in_each_language(lsl, language):
    sender = lsl.add_sender(channels=1)
    shirt = shirt_of(lsl)
    with reader_language(language):
        sentences = [str(shirt.description())]
        shirt.open()
        sentences.append(str(shirt.description()))
        for i in (0, 1, 5):
            sender.send([i], 60.0 + i * PERIOD, late=-9.5)
        read_all(shirt)
        sentences.append(str(shirt.description()))
        sender.end()
        shirt.read(0.0)
        sentences.append(str(from_document(to_document(shirt.description()))))
        shirt.close()
    assert len(set(sentences)) == 4
    assert all(sentence.endswith(".") and "{" not in sentence and "  " not in sentence for sentence in sentences)


@pytest.mark.parametrize("missing", [ModuleNotFoundError("pylsl"), RuntimeError("no liblsl"), OSError("no liblsl")])
def test_without_the_library_it_is_one_sentence(missing):
    def load():
        raise missing

    with pytest.raises(HardwareError, match="LSL is not installed completely: install the packages pylsl and liblsl"):
        LslShirt(LslConfig(kind="lsl"), FakeClock(), load).open()


def test_the_library_is_loaded_only_when_it_is_asked_for(monkeypatch):
    monkeypatch.setitem(sys.modules, "pylsl", None)
    importlib.import_module("app.hardware.shirt.lsl")
    with pytest.raises(ImportError):
        load_lsl()


def test_the_difference_of_two_clocks_is_that_of_the_quickest_comparison():
    waits = [0.0, 0.3, 0.0, 0.2, 0.0, 0.001, 0.0, 0.4, 0.0, 0.5]

    class HeldUp(FakeClock):
        """A clock that is read slowly, except once."""

        def now(self):
            self.time += waits.pop(0)
            return self.time

    clock = HeldUp(10.0)

    class Library:
        def local_clock(self):
            return clock.time + 1000.0

    assert lsl_ahead(Library(), clock) == pytest.approx(1000.0, abs=0.001)
