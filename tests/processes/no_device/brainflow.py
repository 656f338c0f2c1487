"""Stands in for BrainFlow in a process of tests: it has one board, which does not answer."""

import sys
from enum import IntEnum


class BoardIds(IntEnum):
    """The boards."""

    CYTON_BOARD = 0


class BrainFlowError(Exception):
    """Why a call has failed."""

    exit_code = 7


class BrainFlowInputParams:
    """What the board needs."""


class BoardShim:
    """The board."""

    def __init__(self, number, parameters):
        self.number, self.parameters = number, parameters

    @staticmethod
    def disable_board_logger():
        """Do nothing: there is no library of a device."""

    @staticmethod
    def get_board_descr(_number, _preset):
        return {"sampling_rate": 250, "timestamp_channel": 4, "accel_channels": [1, 2, 3]}

    def prepare_session(self):
        raise BrainFlowError("the board does not answer")

    def release_session(self):
        raise BrainFlowError("there is no session")


board_shim = sys.modules[__name__]
