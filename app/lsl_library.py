"""The part of pylsl that the program uses: loaded only where somebody has chosen LSL (decision 64).

LSL, the Lab Streaming Layer (https://labstreaminglayer.org), carries streams of samples through a network; pylsl binds
its library liblsl.
"""

import math
import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Final, Protocol, cast

from app.clock import Clock

OWN_SOURCE: Final = "bodydrive."  # how the source ids of this program's own streams begin
LSL_MISSING: Final = (ImportError, RuntimeError, OSError)
"""What `load_lsl` raises without pylsl, or without liblsl, which pylsl's package lacks for some machines."""

COMPARISONS: Final = 5  # of two clocks: the quickest counts
QUIET: Final = "[log]\nlevel = -2\n"  # errors only; otherwise liblsl lists every network interface on stderr


class LslElement(Protocol):
    """An element of the description of a stream."""

    def empty(self) -> bool:
        """Return whether there is no such element."""
        ...

    def child(self, name: str, /) -> "LslElement":
        """Return the first child of this name, an empty element when there is none."""
        ...

    def next_sibling(self, name: str, /) -> "LslElement":
        """Return the next element of this name beside this one, an empty element when there is none."""
        ...

    def child_value(self, name: str, /) -> str:
        """Return the text of the first child of this name, empty when there is none."""
        ...

    def append_child(self, name: str, /) -> "LslElement":
        """Add a child and return it."""
        ...

    def append_child_value(self, name: str, value: str, /) -> "LslElement":
        """Add a child that holds a text, and return this element."""
        ...


class LslInfo(Protocol):
    """What a stream says of itself."""

    def name(self) -> str:
        """Return the name of the stream."""
        ...

    def type(self) -> str:
        """Return the kind of its content, such as EEG."""
        ...

    def source_id(self) -> str:
        """Return what names the device, also after a new start; may be empty."""
        ...

    def hostname(self) -> str:
        """Return the name of the machine that sends."""
        ...

    def uid(self) -> str:
        """Return the name of this start of the stream."""
        ...

    def channel_count(self) -> int:
        """Return the number of channels."""
        ...

    def channel_format(self) -> int:
        """Return the type of the values, one of the constants cf_..."""
        ...

    def nominal_srate(self) -> float:
        """Return the samples per second (Hz), 0 for a stream without a rate."""
        ...

    def desc(self) -> LslElement:
        """Return the root of the description."""
        ...


class LslInlet(Protocol):
    """Receives one stream; what it cannot do raises RuntimeError. Its end may take half a second."""

    def info(self, timeout: float) -> LslInfo:
        """Return what the stream says of itself, with its description."""
        ...

    def open_stream(self, timeout: float) -> None:
        """Begin to receive."""
        ...

    def time_correction(self, timeout: float) -> float:
        """Return what added to the sender's time stamps (s) gives this machine's LSL clock."""
        ...

    def pull_sample(self, timeout: float) -> tuple[Sequence[float] | None, float | None]:
        """Return the next sample and its time stamp (s); None, None when none came within `timeout` (s)."""
        ...

    def pull_chunk(self, timeout: float, max_samples: int) -> tuple[Sequence[Sequence[float]], Sequence[float]]:
        """Return the next samples and their time stamps (s)."""
        ...

    def samples_available(self) -> int:
        """Return how many samples have come, or 1 for some."""
        ...


class LslOutlet(Protocol):
    """Sends one stream."""

    def push_chunk(self, x: object, timestamp: Sequence[float]) -> None:
        """Send samples, one row each, with their time stamps (s)."""
        ...

    def have_consumers(self) -> bool:
        """Return whether anybody receives."""
        ...


class LslLibrary(Protocol):
    """The module pylsl."""

    cf_double64: int
    cf_string: int
    StreamInfo: Callable[..., LslInfo]
    StreamInlet: Callable[..., LslInlet]
    StreamOutlet: Callable[..., LslOutlet]

    def local_clock(self) -> float:
        """Return the time (s) of this machine's LSL clock."""
        ...

    def resolve_streams(self, wait_time: float) -> Sequence[LslInfo]:
        """Return all streams on the network that answer within `wait_time` (s)."""
        ...


def load_lsl() -> LslLibrary:
    """Load pylsl; raise one of LSL_MISSING when it is not complete."""
    import pylsl  # noqa: PLC0415  # takes long, and opens sockets when it is used

    if not any(file.is_file() for file in _configurations()):
        with suppress(NotImplementedError):
            pylsl.set_config_content(QUIET)
    return cast(LslLibrary, pylsl)


def lsl_ahead(lsl: LslLibrary, clock: Clock) -> float:
    """Return by how much (s) LSL's clock is ahead of `clock`, by the quickest of some comparisons.

    LSL's clock stands while the machine sleeps, ours does not: the difference changes then.
    """
    ahead, least = 0.0, math.inf
    for _ in range(COMPARISONS):
        before = clock.now()
        t = lsl.local_clock()
        after = clock.now()
        if after - before < least:
            ahead, least = t - (before + after) / 2.0, after - before
    return ahead


def _configurations() -> list[Path]:
    """Return the places where liblsl looks for a configuration of people."""
    chosen = os.environ.get("LSLAPICFG")
    places = [Path("lsl_api.cfg"), Path.home() / "lsl_api" / "lsl_api.cfg", Path("/etc/lsl_api/lsl_api.cfg")]
    return [Path(chosen), *places] if chosen else places
