"""The ring of ticks in shared memory, from the control process to its readers; the writer never waits for a reader."""

import mmap
import os
import tempfile
from pathlib import Path
from struct import Struct

import numpy as np
from numpy.typing import NDArray

from app.messages import MAX_GESTURES, TICK, Tick

RING_SLOTS = 16_384  # 16 s at 1 kHz, 160 s at 100 Hz
HEADER = 64  # bytes before the slots: the number of the newest tick, then padding
COPY_ATTEMPTS = 3  # of `newest`, when the writer overwrites the slot that is being copied
SCALAR_FIELDS = [name for name in TICK.names or () if name != "number" and not TICK[name].shape]
NUMBER_WORDS = TICK.itemsize // 8  # size of a slot in words of 8 bytes; a slot's number is written as one such word

Ticks = NDArray[np.void]


def ring_file(name: str) -> Path:
    """Return the file of the memory `name`: in the system's shared memory, or else in the temporary folder."""
    shared = Path("/dev/shm")  # noqa: S108
    return (shared if shared.is_dir() else Path(tempfile.gettempdir())) / name


def _slot_layout(n_gestures: int) -> Struct:
    """Return the format of the fields of `TICK` after `number` up to the activations; unused gestures become zero."""
    unused = 8 * (MAX_GESTURES - n_gestures)
    scalars = "".join(TICK[name].char for name in SCALAR_FIELDS)  # numpy and struct have the same letters for types
    return Struct(f"@{scalars}{n_gestures}d{unused}x{n_gestures}d{unused}x{n_gestures}d")


class TickRing:
    """The last RING_SLOTS ticks, with one writer and any number of readers, which do not affect the writer.

    A slot's number is 0 while the slot is being written. A reader compares the number before and after copying: when it
    has changed, the copy is torn and is discarded.
    The memory is a mapped file and not `multiprocessing.shared_memory`, because the latter's tracker starts a process
    of its own and, up to Python 3.12, removes the memory when a reader ends.
    """

    def __init__(self, file: Path, descriptor: int) -> None:
        self._file = file
        self._memory = mmap.mmap(descriptor, HEADER + RING_SLOTS * TICK.itemsize)
        self._slots: Ticks = np.frombuffer(self._memory, dtype=TICK, offset=HEADER)
        self._bytes = np.frombuffer(self._memory, dtype=np.uint8, offset=HEADER).reshape(RING_SLOTS, TICK.itemsize)
        self._numbers = self._slots["number"]
        self._values = self._slots["values"]
        self._words = memoryview(self._memory).cast("Q")
        self._layouts = [_slot_layout(n) for n in range(MAX_GESTURES + 1)]
        self._number = 0
        self._n_channels = 0

    @classmethod
    def create(cls, name: str) -> "TickRing":
        """Make the memory and return the writer's end.

        Raises
        ------
        FileExistsError
            When a memory of this name exists.
        """
        file = ring_file(name)
        descriptor = os.open(file, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
        try:
            os.ftruncate(descriptor, HEADER + RING_SLOTS * TICK.itemsize)
            ring = cls(file, descriptor)
        except BaseException:
            file.unlink(missing_ok=True)
            raise
        finally:
            os.close(descriptor)
        ring._slots["values"] = np.nan  # also touches every page, so that the loop has no page faults later
        return ring

    @classmethod
    def attach(cls, name: str) -> "TickRing":
        """Open the memory that another process has made, and return a reader's end.

        Raises
        ------
        FileNotFoundError
            When no memory of this name exists.
        """
        file = ring_file(name)
        descriptor = os.open(file, os.O_RDWR)
        try:
            return cls(file, descriptor)
        finally:
            os.close(descriptor)

    def unlink(self) -> None:
        """Remove the memory's name; processes that have the memory open keep it."""
        self._file.unlink(missing_ok=True)

    @property
    def number(self) -> int:
        """The newest tick's number, 0 before the first."""
        return int(self._words[0])

    def write(self, tick: Tick, run: int, run_t: float, cue: int, lost: int, late: int) -> None:
        """Append a tick. `run_t` in s, NaN outside a run; `lost` and `late` as in `app.messages.TICK`."""
        self._number = number = self._number + 1
        slot = number % RING_SLOTS
        words = self._words
        at = HEADER // 8 + slot * NUMBER_WORDS
        words[at] = 0
        values = tick.values
        if values is None:
            self._values[slot] = np.nan
            has_frame = 0
        else:
            self._n_channels = n = len(values)
            self._values[slot, :n] = values
            has_frame = 1
        score = tick.score
        n_gestures = len(score)
        self._layouts[n_gestures].pack_into(
            self._memory,
            8 * at + 8,
            tick.t,
            tick.t_device,
            run_t,
            tick.u1,
            tick.u2,
            tick.v,
            tick.omega,
            tick.x,
            tick.y,
            tick.theta,
            tick.scene_t,
            tick.estimated,
            tick.frame_seq,
            lost,
            late,
            tick.contacts,
            run,
            tick.stops,
            cue,
            tick.dial,
            tick.chair_age,
            tick.battery,
            tick.driven_v,
            tick.driven_omega,
            tick.head_yaw,
            tick.head_pitch,
            tick.head_roll,
            tick.head_age,
            self._n_channels,
            n_gestures,
            has_frame,
            tick.state,
            tick.fault,
            tick.in_contact,
            tick.chair_kind,
            tick.chair_state,
            tick.chair_fault,
            tick.stop_input,
            tick.own_joystick,
            tick.measured,
            *score,
            *tick.rate,
            *tick.activation,
        )
        words[at] = number
        words[0] = number

    def newest(self) -> np.void | None:
        """Return a copy of the newest tick, None before the first."""
        for _ in range(COPY_ATTEMPTS):
            number = self.number
            if number == 0:
                return None
            slot = number % RING_SLOTS
            if self._numbers[slot] == number:
                copy: np.void = self._slots[slot].copy()
                if self._numbers[slot] == number:
                    return copy
        return None

    def since(self, number: int) -> tuple[Ticks, int]:
        """Return copies of the ticks after `number`, in order, and the number of ticks that were overwritten."""
        newest = self.number
        if newest <= number:
            return np.empty(0, dtype=TICK), 0
        first = max(number + 1, newest - RING_SLOTS + 1)
        expected = np.arange(first, newest + 1, dtype=np.uint64)
        slots = (expected % np.uint64(RING_SLOTS)).astype(np.intp)
        before = self._numbers[slots] == expected
        ticks = self._bytes[slots].view(TICK)[:, 0]  # copied as bytes: ten times as fast as copying structured slots
        whole = before & (self._numbers[slots] == expected)
        torn = np.flatnonzero(~whole)
        start = int(torn[-1]) + 1 if len(torn) else 0
        return ticks[start:], first + start - number - 1

    def close(self) -> None:
        """Release the memory; copies of ticks stay valid."""
        self._words.release()
        del self._slots, self._bytes, self._numbers, self._values
        self._memory.close()
