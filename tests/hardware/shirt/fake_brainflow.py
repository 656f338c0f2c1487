"""The part of brainflow.board_shim that the program uses, without a board: samples are put in by the test."""

import threading
from enum import IntEnum

import numpy as np

PRESETS = ("default", "auxiliary", "ancillary")
CYTON = {
    "name": "Cyton",
    "sampling_rate": 250,
    "package_num_channel": 0,
    "timestamp_channel": 7,
    "num_rows": 8,
    "eeg_channels": [1, 2],
    "emg_channels": [1, 2, 3],
    "accel_channels": [4, 5, 6],
}


class BoardIds(IntEnum):
    """Some of BrainFlow's numbers."""

    PLAYBACK_FILE_BOARD = -3
    SYNTHETIC_BOARD = -1
    CYTON_BOARD = 0
    GANGLION_BOARD = 1
    CALLIBRI_EMG_BOARD = 10


class BrainFlowError(Exception):
    """As BrainFlow raises for an exit code that is not 0."""

    def __init__(self, message, exit_code):
        super().__init__(f"{message}:{exit_code}")
        self.exit_code = exit_code


class BrainFlowInputParams:
    """What a board needs to be found."""

    def __init__(self):
        self.serial_port = self.mac_address = self.ip_address = self.serial_number = self.other_info = ""
        self.ip_port = self.timeout = 0


class FakeBoardShim:
    """One board as the program holds it; `calls` has what was called, but for the questions for samples."""

    def __init__(self, library, number, parameters):
        self.number, self.parameters = number, parameters
        self._library = library
        library.shims.append(self)

    def prepare_session(self):
        self._note("prepare_session")
        if self._library.is_gone:
            raise BrainFlowError("BOARD_NOT_READY_ERROR", 7)
        self._library.is_prepared = True

    def start_stream(self, num_samples):
        self._note("start_stream")
        if self._library.stream_error:
            raise BrainFlowError("STREAM_THREAD_ERROR", self._library.stream_error)
        self.kept = num_samples
        self._library.started.set()

    def get_board_data_count(self, preset):
        self._require()
        return len(self._library.samples[preset])

    def get_board_data(self, *, preset):
        self._require()
        with self._library.lock:
            samples, self._library.samples[preset] = self._library.samples[preset], []
        return np.array(samples, dtype=np.float64).T

    def release_session(self):
        self._note("release_session")
        if not self._library.is_prepared:
            raise BrainFlowError("BOARD_NOT_CREATED_ERROR", 15)
        self._library.is_prepared = False

    def _note(self, call):
        self._library.calls.append((call, threading.current_thread().name))

    def _require(self):
        if self._library.is_gone or not self._library.is_prepared:
            raise BrainFlowError("BOARD_NOT_CREATED_ERROR", 15)


class FakeBrainFlow:
    """The module brainflow.board_shim with one board, of whose streams `descriptions` has one each."""

    def __init__(self, description=CYTON):
        self.BoardIds, self.BrainFlowError, self.BrainFlowInputParams = BoardIds, BrainFlowError, BrainFlowInputParams
        self.BoardShim = self
        self.descriptions = {0: description}
        self.samples = {preset: [] for preset in range(len(PRESETS))}
        self.shims, self.calls = [], []
        self.is_prepared = self.is_gone = False
        self.stream_error = 0
        self.lock = threading.Lock()
        self.started = threading.Event()  # set again at each start of the stream

    def __call__(self, number, parameters):
        return FakeBoardShim(self, number, parameters)

    def get_board_descr(self, _number, preset):
        if preset not in self.descriptions:
            raise BrainFlowError("UNSUPPORTED_BOARD_ERROR", 14)
        return self.descriptions[preset]

    def send(self, samples, preset=0):
        """Let samples come at once, each (n_rows,)."""
        with self.lock:
            self.samples[preset] = [*self.samples[preset], *samples]
