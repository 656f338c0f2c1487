"""BrainFlow as far as the program uses it: its boards, and which channels of one become a shirt. No device.

BrainFlow (https://brainflow.org) reads boards of many makers. Its package, the extra `brainflow`, binds a library in C.
"""

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from enum import IntEnum
from typing import Any, Final, NamedTuple, Protocol, cast

import numpy as np
from numpy.typing import NDArray

from app.hardware.base import HardwareError
from app.hardware.shirt.kind import HIGHEST_RATE, LOWEST_RATE
from app.layout import MAX_CHANNELS, Channel, Joint, ShirtLayout
from app.texts import Text

BRAINFLOW_MISSING: Final = (ImportError, OSError)
"""What `load_brainflow` raises without the package, or where its library in C cannot be loaded."""

MOST_NAMED: Final = 3  # boards in a sentence
ALIKE: Final = 0.3  # how alike two names are that may be meant
ELECTRODES: Final = ("eeg", "emg", "ecg", "eog")  # kinds of data that together are BrainFlow's "exg"
OF_CHANNELS: Final = "_channels"  # how the keys of a description end that name the rows of a kind of data


class BrainFlowBoard(Protocol):
    """The part of BrainFlow's BoardShim that is used; what it cannot do raises BrainFlowError."""

    def prepare_session(self) -> None:
        """Connect the board; takes as long as the board is looked for."""
        ...

    def start_stream(self, num_samples: int) -> None:
        """Let the board send; the newest `num_samples` samples are kept."""
        ...

    def get_board_data_count(self, preset: int) -> int:
        """Return how many samples of a stream have come."""
        ...

    def get_board_data(self, *, preset: int) -> NDArray[np.float64]:
        """Return the samples (n_rows, n) of a stream that have come, and keep them no longer."""
        ...

    def release_session(self) -> None:
        """End the stream, and disconnect the board."""
        ...


class BrainFlowLibrary(Protocol):
    """The module brainflow.board_shim."""

    BoardIds: type[IntEnum]
    BoardShim: Any  # makes a BrainFlowBoard of a number and parameters; describes boards
    BrainFlowInputParams: Callable[[], Any]
    BrainFlowError: type[Exception]


class BoardChannels(NamedTuple):
    """What becomes a shirt of one stream of a board."""

    rows: Mapping[str, int]  # of the samples, by the name of the channel
    timestamp: int  # the row with the time, s
    rate: float  # Hz


def load_brainflow() -> BrainFlowLibrary:
    """Load BrainFlow and its library in C, and let it log nothing; raise one of BRAINFLOW_MISSING without them."""
    from brainflow import board_shim  # noqa: PLC0415  # the web process imports this file, too

    board_shim.BoardShim.disable_board_logger()
    return cast(BrainFlowLibrary, board_shim)


def board_number(boards: type[IntEnum], given: str) -> int:
    """Return BrainFlow's number of a board by its name, with or without _BOARD at its end, or by its number.

    Raises
    ------
    HardwareError
        When BrainFlow has no such board, or nobody wears it: boards with negative numbers play or make signals.
    """
    names, name = boards.__members__, given.upper()
    found = names.get(name, names.get(f"{name}_BOARD"))
    if found is None and name.isdecimal():
        found = next((board for board in boards if board.value == int(name)), None)
    if found is None:
        worn = [each for each, board in names.items() if board.value >= 0]
        alike = get_close_matches(name, worn, MOST_NAMED, ALIKE) or worn[:MOST_NAMED]
        raise HardwareError(Text("shirtdev-brainflow-no-board", given=given, boards=alike))
    if found.value < 0:
        raise HardwareError(Text("shirtdev-brainflow-nobody-wears", board=found.name))
    return int(found.value)


def kinds_of_data(description: Mapping[str, Any]) -> dict[str, list[int]]:
    """Return the rows of each kind of data in BrainFlow's description of a board; "exg" are those of all electrodes."""
    named = {key: rows for key, rows in description.items() if key.endswith(OF_CHANNELS)}
    kinds = {key.removesuffix(OF_CHANNELS): [int(row) for row in rows] for key, rows in named.items()}
    electrodes = sorted({row for kind in ELECTRODES for row in kinds.get(kind, [])})
    return ({"exg": electrodes} if electrodes else {}) | kinds


def chosen_channels(description: Mapping[str, Any], board: str, data: str) -> BoardChannels:
    """Return the channels of the kinds of data that stand between the commas of `data`, each row once.

    Raises
    ------
    HardwareError
        When the board has no such data, too many channels, or a rate that no shirt can have.
    """
    kinds, rows = kinds_of_data(description), dict[str, int]()
    sought = [kind for kind in (part.strip().lower() for part in data.split(",")) if kind]
    if not sought or not set(sought) <= kinds.keys():
        raise HardwareError(Text("shirtdev-brainflow-no-data", board=board, kinds=list(kinds) or ["-"]))
    for kind in sought:
        for number, row in enumerate(kinds[kind], 1):
            if row not in rows.values():
                rows[f"{kind}_{number}"] = row
    if len(rows) > MAX_CHANNELS:
        raise HardwareError(Text("shirtdev-brainflow-channels", board=board, channels=len(rows), most=MAX_CHANNELS))
    rate = float(description.get("sampling_rate", 0.0))
    if not LOWEST_RATE <= rate <= HIGHEST_RATE:
        limits = {"low": LOWEST_RATE, "high": HIGHEST_RATE}
        raise HardwareError(Text("shirtdev-brainflow-rate", board=board, rate=round(rate, 2), **limits))
    return BoardChannels(rows, int(description["timestamp_channel"]), rate)


def board_layout(board: str, names: Iterable[str]) -> ShirtLayout:
    """Return a layout in which each kind of data is a joint: emg_1 and emg_2 belong to the joint emg."""
    joints = {name: name.rpartition("_")[0] for name in names}
    return ShirtLayout(
        name=board,
        channels=tuple(Channel(name=name, joint=joint) for name, joint in joints.items()),
        joints=tuple(Joint(name=joint, label=joint.capitalize()) for joint in dict.fromkeys(joints.values())),
    )
