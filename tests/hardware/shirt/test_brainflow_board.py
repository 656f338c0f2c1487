"""The shirt of a board that BrainFlow reads: on a stand-in, and with BrainFlow's own synthetic and playback boards."""

import threading
import warnings

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.fake_brainflow import CYTON, BoardIds, FakeBrainFlow
from hardware.shirt.shirts import RATE, BrainFlowCase, FedBoard, small_layout
from pydantic import ValidationError

from app.clock import MonotonicClock, monotonic
from app.hardware.base import HardwareError
from app.hardware.shirt import brainflow_board
from app.hardware.shirt.brainflow_board import LOOK, BrainFlowConfig, BrainFlowShirt
from app.hardware.shirt.brainflow_library import (
    BRAINFLOW_MISSING,
    board_layout,
    board_number,
    chosen_channels,
    kinds_of_data,
    load_brainflow,
)
from app.layout import MAX_CHANNELS
from app.texts import LANGUAGES, from_document, reader_language, to_document
from needed import lacks

LONG_ENOUGH = 20.0  # s that anything between two threads may take
DAY = 86_400.0  # s


def shirt_of(library, clock=None, **fields):
    return BrainFlowShirt(BrainFlowConfig(kind="brainflow", **fields), clock or MonotonicClock(), lambda: library)


@pytest.fixture
def source(tmp_path):
    made = BrainFlowCase(tmp_path)
    made.shirt.open()
    yield made
    made.shirt.close()


def test_even_samples_are_even_frames_also_in_bursts():
    fed, frames = FedBoard(), []
    for burst in range(50):
        stamps = 1e9 + (4 * burst + np.arange(4)) / RATE
        frames += fed.frames(stamps, delay=4 / RATE)
    assert [frame.seq for frame in frames] == list(range(200))
    np.testing.assert_allclose(np.diff([frame.t_device for frame in frames]), 1 / RATE, atol=1e-5)
    assert fed.shirt.lost == 0


def test_what_a_radio_lost_is_a_gap():
    fed = FedBoard()
    frames = fed.frames([1e9 + i / RATE for i in (0, 1, 2, 6, 7)])
    assert [frame.seq for frame in frames] == [0, 1, 2, 6, 7]
    assert fed.shirt.lost == 3


@pytest.mark.parametrize("step", [DAY, -DAY, 7.0, -7.0])
def test_a_step_of_the_machines_time_loses_nothing_and_the_clock_goes_on(step):
    """Safety S16: BrainFlow stamps samples by the machine's time, which can be set."""
    fed, frames = FedBoard(), []
    for number in range(40):
        stamps = [1e9 + number / RATE + (step if number >= 20 else 0.0)]
        frames += fed.frames(stamps, delay=1 / RATE)
    before, after = 1e9 + 41 / RATE + step, 1e9 + 42 / RATE
    frames += fed.frames([before, after], delay=2 / RATE)  # within one chunk
    assert [frame.seq for frame in frames] == list(range(42))
    assert fed.shirt.lost == 0
    assert np.diff([frame.t_device for frame in frames]).max() < 2.5 / RATE


def test_the_age_of_the_newest_sample_is_shown():
    fed = FedBoard()
    fed.frames([1e9])
    fed.frames([1e9 + 0.01], delay=0.05)
    assert "1 frame" not in str(fed.shirt.description())
    assert "40 ms later than the quickest" in str(fed.shirt.description())


def test_the_loop_waits_for_no_call_of_the_library(source):
    source.let_come(3)
    source.shirt.read(LONG_ENOUGH)
    with source.brainflow.lock:  # as BrainFlow holds its own while it looks for a board
        source.brainflow.samples[0] = [[0.0] * 8]
        before = source.clock.now()
        for _ in range(5):
            source.shirt.read(0.002)
            source.shirt.pending()
            source.shirt.description()
        assert source.clock.now() - before < LONG_ENOUGH / 2
    in_loop = [call for call, thread in source.brainflow.calls if thread != "BrainFlow"]
    assert in_loop == ["prepare_session", "start_stream"]  # of `open`, which has a thread of its own


def test_a_board_that_is_lost_is_silent_and_comes_back(source, monkeypatch):
    monkeypatch.setattr(brainflow_board, "REOPEN_AFTER", 0.01)
    source.let_come(1)
    assert source.shirt.read(LONG_ENOUGH).seq == 0
    source.brainflow.started.clear()
    source.brainflow.is_gone = True
    end = monotonic() + LONG_ENOUGH
    while not source.shirt._reader.trouble and monotonic() < end:
        assert source.shirt.read(0.01) is None
    source.shirt._watch.accepted_t -= 1.0
    assert "Nothing arrives from the board CYTON_BOARD (BOARD_NOT" in str(source.shirt.description())
    source.brainflow.is_gone = False
    assert source.brainflow.started.wait(LONG_ENOUGH)
    source.let_come(1)
    frame = source.shirt.read(LONG_ENOUGH)
    assert frame.values[0] == 1
    assert source.shirt.lost == frame.seq - 1


def test_the_reason_of_a_lost_board_stays_until_it_is_back(source, monkeypatch):
    monkeypatch.setattr(brainflow_board, "REOPEN_AFTER", 0.01)
    source.let_come(1)
    assert source.shirt.read(LONG_ENOUGH).seq == 0
    reader, calls = source.shirt._reader, source.brainflow.calls
    source.brainflow.is_gone = True
    end = monotonic() + LONG_ENOUGH
    while reader.trouble != "BOARD_NOT_READY_ERROR:7" and monotonic() < end:
        """Wait until the board was sought in vain."""
    troubles, tries = set(), calls.count(("prepare_session", "BrainFlow"))
    while calls.count(("prepare_session", "BrainFlow")) < tries + 5 and monotonic() < end:
        troubles.add(reader.trouble)
    assert troubles == {"BOARD_NOT_READY_ERROR:7"}


def test_a_board_that_only_falls_silent_is_opened_anew(source, monkeypatch):
    monkeypatch.setattr(brainflow_board, "REOPEN_AFTER", 0.01)
    monkeypatch.setattr(brainflow_board, "SILENT", 0.02)
    source.brainflow.started.clear()
    assert source.brainflow.started.wait(LONG_ENOUGH)


def test_closing_releases_the_board_in_its_thread(source):
    thread = source.shirt._reader
    source.shirt.close()
    thread.join(LONG_ENOUGH)
    assert source.brainflow.calls[-1] == ("release_session", "BrainFlow")
    assert not source.brainflow.is_prepared


def test_what_the_board_needs_is_handed_on():
    library = FakeBrainFlow()
    shirt = shirt_of(library, board="0", serial_port="/dev/ttyUSB0", mac_address="a1:b2:c3:d4:e5:f6", ip_port=6677)
    shirt.open()
    shirt.close()
    (shim,) = library.shims
    needs = shim.parameters
    assert (shim.number, needs.serial_port, needs.mac_address) == (0, "/dev/ttyUSB0", "a1:b2:c3:d4:e5:f6")
    assert (needs.ip_port, needs.ip_address, needs.timeout) == (6677, "", LOOK)
    assert shim.kept == 2500  # ten seconds


@pytest.mark.parametrize(
    ("given", "number"), [("CYTON_BOARD", 0), ("cyton", 0), ("0", 0), ("Callibri_EMG", 10), ("10", 10)]
)
def test_a_board_is_named_as_people_write_it(given, number):
    assert board_number(BoardIds, given) == number


@pytest.mark.parametrize("given", ["CYTN", "99", "board", "-"])
def test_a_board_that_brainflow_does_not_have_is_one_sentence_with_those_that_it_may_be(given):
    with pytest.raises(HardwareError, match=f"BrainFlow has no board {given}: write the name or the number") as refused:
        board_number(BoardIds, given)
    assert "SYNTHETIC" not in str(refused.value)
    assert given != "CYTN" or "CYTON_BOARD" in str(refused.value)


@pytest.mark.parametrize("given", ["SYNTHETIC_BOARD", "synthetic", "PLAYBACK_FILE_BOARD"])
def test_signals_that_nobody_makes_are_no_shirt(given):
    """Safety S26: a kind that somebody wears has no simulated source in it."""
    with pytest.raises(HardwareError, match="nobody wears it"):
        board_number(BoardIds, given)


def test_channels_are_chosen_by_the_kinds_of_data_of_the_board():
    assert kinds_of_data(CYTON) == {"exg": [1, 2, 3], "eeg": [1, 2], "emg": [1, 2, 3], "accel": [4, 5, 6]}
    assert chosen_channels(CYTON, "A", " Accel ,, emg").rows == {
        **{f"accel_{number}": number + 3 for number in (1, 2, 3)},
        **{f"emg_{number}": number for number in (1, 2, 3)},
    }
    assert list(chosen_channels(CYTON, "A", "eeg,exg").rows.values()) == [1, 2, 3]  # each row once
    layout = board_layout("CYTON_BOARD", chosen_channels(CYTON, "A", "accel,eeg").rows)
    assert layout.joint_names == ["accel", "eeg"]
    assert [joint.label for joint in layout.joints] == ["Accel", "Eeg"]


@pytest.mark.parametrize(
    ("change", "data", "sentence"),
    [
        ({}, "silk", "this stream of the board A has exg, eeg, emg and accel: write one of these"),
        ({}, ",", "this stream of the board A has"),
        ({"accel_channels": [*range(MAX_CHANNELS + 1)]}, "accel", "has 65 channels with these data, at most 64"),
        ({"sampling_rate": 1}, "accel", "has 1 samples a second, 10 to 2000"),
        ({"sampling_rate": 16_000}, "accel", "samples a second, 10 to 2000"),
    ],
)
def test_data_that_make_no_shirt_are_one_sentence(change, data, sentence):
    with pytest.raises(HardwareError) as refused:
        chosen_channels({**CYTON, **change}, "A", data)
    assert sentence in str(refused.value).replace("2,000", "2000")


def test_a_layout_that_was_brought_counts_and_must_fit():
    shirt = shirt_of(FakeBrainFlow(), layout=small_layout())
    shirt.open()
    assert shirt.layout == small_layout()
    shirt.close()
    with pytest.raises(HardwareError, match="the board has 6 channels with these data and the layout 3"):
        shirt_of(FakeBrainFlow(), data="exg,accel", layout=small_layout()).open()


@pytest.mark.parametrize(
    ("break_it", "sentence"),
    [
        (lambda library: setattr(library, "is_gone", True), r"cannot be opened \(BOARD_NOT.*: switch it on"),
        (lambda library: setattr(library, "stream_error", 13), "fill in what BrainFlow's list asks for"),
        (lambda library: setattr(library, "stream_error", 2), "check its serial line"),
        (lambda library: setattr(library, "stream_error", 17), "check that it is on"),
        (lambda library: library.descriptions.clear(), "has no such stream: choose another one"),
    ],
)
def test_a_board_that_cannot_be_opened_is_one_sentence_and_leaves_nothing_open(break_it, sentence):
    library = FakeBrainFlow()
    break_it(library)
    shirt = shirt_of(library)
    with pytest.raises(HardwareError, match=sentence):
        shirt.open()
    assert not library.is_prepared
    assert str(shirt.description()) == "No board is open."
    assert not [thread for thread in threading.enumerate() if thread.name == "BrainFlow"]


@pytest.mark.parametrize("error", [ModuleNotFoundError("No module named 'brainflow'"), OSError("wrong ELF class")])
def test_without_brainflow_it_says_what_to_install(error):
    def load():
        raise error

    shirt = BrainFlowShirt(BrainFlowConfig(kind="brainflow"), FakeClock(), load)
    with pytest.raises(HardwareError, match=r"need the library BrainFlow \(.*pip install 'bodydrive\[brainflow\]'"):
        shirt.open()


@pytest.mark.parametrize(
    "field", [{"serial_port": "/dev/zero"}, {"mac_address": "a b"}, {"ip_address": "a b"}, {"ip_port": 70_000},
              {"serial_number": "\u200b"}, {"other_info": '"'}, {"board": ""}, {"data": ""}, {"preset": "4"}]
)  # fmt: skip
def test_a_field_that_cannot_be_is_refused(field):
    with pytest.raises(ValidationError):
        BrainFlowConfig(kind="brainflow", **field)


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_it_says_is_a_sentence_in_every_language(source, language):
    source.let_come(1)
    source.shirt.read(LONG_ENOUGH)
    running = source.shirt.description()
    source.shirt._watch.accepted_t -= 1.0
    with reader_language(language):
        for text in (running, source.shirt.description()):
            sentence = str(from_document(to_document(text)))
            assert "CYTON_BOARD" in sentence
            assert sentence.endswith(".")
            assert "{" not in sentence


class Redirected:
    """BrainFlow itself, where one of its own boards without hardware answers in place of the Cyton."""

    def __init__(self, library, number, **parameters):
        self.BoardIds, self.BrainFlowError = library.BoardIds, library.BrainFlowError
        self.BrainFlowInputParams = library.BrainFlowInputParams
        self.BoardShim = self
        self._library, self._number, self._parameters = library, number, parameters

    def __call__(self, number, parameters):
        assert number == self.BoardIds.CYTON_BOARD
        for name, value in self._parameters.items():
            setattr(parameters, name, value)
        return self._library.BoardShim(self._number, parameters)

    def get_board_descr(self, _number, preset):
        return self._library.BoardShim.get_board_descr(self._library.BoardIds.SYNTHETIC_BOARD, preset)


@pytest.fixture(scope="module")
def brainflow():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what BrainFlow imports
        try:
            return load_brainflow()
        except BRAINFLOW_MISSING as error:
            lacks(f"there is no BrainFlow here ({error}): install the extra 'brainflow'")


@pytest.mark.parametrize("preset", ["default", "auxiliary"])
def test_the_synthetic_board_of_brainflow_sends_frames(brainflow, preset):
    shirt = shirt_of(Redirected(brainflow, brainflow.BoardIds.SYNTHETIC_BOARD), data="accel, gyro", preset=preset)
    shirt.open()
    try:
        assert shirt.layout.joint_names == ["accel", "gyro"]
        assert shirt.sample_rate >= 10.0
        frames = [shirt.read(LONG_ENOUGH) for _ in range(50)]
    finally:
        shirt.close()
    assert all(frame.values.shape == (6,) and np.isfinite(frame.values).all() for frame in frames)
    assert (np.diff([frame.seq for frame in frames]) >= 1).all()
    assert (np.diff([frame.t_device for frame in frames]) > 0.0).all()


def test_the_playback_board_of_brainflow_loses_no_sample(brainflow, tmp_path):
    synthetic = brainflow.BoardIds.SYNTHETIC_BOARD
    description = brainflow.BoardShim.get_board_descr(synthetic, 0)
    samples = np.zeros((100, description["num_rows"]))
    samples[:, description["accel_channels"][0]] = np.arange(100)
    samples[:, description["timestamp_channel"]] = 1e9 + np.arange(100) / description["sampling_rate"]
    file = tmp_path / "board.csv"
    np.savetxt(file, samples, fmt="%.6f", delimiter="\t")
    played = Redirected(brainflow, brainflow.BoardIds.PLAYBACK_FILE_BOARD, file=str(file), master_board=synthetic.value)
    shirt = shirt_of(played)
    shirt.open()
    try:
        frames = [shirt.read(LONG_ENOUGH) for _ in range(100)]
    finally:
        shirt.close()
    assert [frame.values[0] for frame in frames] == list(range(100))
    assert shirt.layout.channel_names == ["accel_1", "accel_2", "accel_3"]


def test_every_real_board_that_fits_has_channels_and_a_layout(brainflow):
    """The descriptions of BrainFlow's own list: none of them raises anything else than one sentence."""
    usable = 0
    for board in brainflow.BoardIds:
        try:
            description = brainflow.BoardShim.get_board_descr(board.value, 0)
        except brainflow.BrainFlowError:
            continue
        try:
            number = board_number(brainflow.BoardIds, board.name)
            channels = chosen_channels(description, board.name, next(iter(kinds_of_data(description)), "none"))
        except HardwareError:
            continue
        assert number == board.value
        assert len(board_layout(board.name, channels.rows).channels) == len(channels.rows)
        usable += 1
    assert usable > 20
