"""The number of the newest frame accepted under a key, kept on disk: no frame is accepted twice (safety S23)."""

import re
import threading
from pathlib import Path

from app.files import write_atomically
from app.hardware.base import HardwareError
from app.texts import Text

LARGEST_SEQ = 0xFFFFFFFF  # u32
FrameNumber = tuple[int, int]
"""Boot counter and seq of a frame."""

_LINE = re.compile(r"(\d{1,20}) (\d{1,10})")


def newest_file(key_file: Path) -> Path:
    """Return the file that holds the newest frame's number for a key file."""
    return key_file.with_suffix(".newest")


def write_newest(file: Path, number: FrameNumber) -> None:
    """Write the number of the newest frame, whole or not at all; raise OSError when that fails."""
    write_atomically(file, f"{number[0]} {number[1]}\n".encode())


def read_newest(file: Path) -> FrameNumber:
    """Return the number of the newest frame; HardwareError without a readable file, for then any frame could be old."""
    try:
        match = _LINE.fullmatch(file.read_text(encoding="ascii").strip()) if file.is_file() else None
    except (OSError, ValueError):
        match = None
    if match is None:
        raise HardwareError(Text("shirtdev-newest-unknown", file=str(file)))
    return int(match[1]), int(match[2])


class NewestFrame:
    """Accepts each frame of a key once, also after a crash of this process, without waiting for the disk.

    A thread writes the file ahead: the file names a frame `ahead` frames later than the newest, and only frames up to
    that one are accepted. After a crash at most `ahead` frames are refused, or all until the shirt is started again.
    """

    def __init__(self, file: Path, ahead: int) -> None:
        """`ahead` is the number of frames that one write allows."""
        self._file = file
        self._ahead = ahead
        self._newest: FrameNumber = (0, 0)
        self._allowed: FrameNumber = (0, 0)  # the number on the disk
        self._wanted: FrameNumber | None = None
        self._wake = threading.Event()
        self._ended = False
        self._thread: threading.Thread | None = None
        self.trouble: Text | None = None  # why the file cannot be written, None while it can

    def open(self) -> None:
        """Read the file and start the thread; HardwareError when the file cannot be read."""
        self._newest = self._allowed = read_newest(self._file)
        self._thread = threading.Thread(target=self._write_ahead, name="newest frame", daemon=True)
        self._thread.start()

    def is_new(self, boot: int, seq: int) -> bool:
        """Return whether this frame is newer than every frame that may have been accepted."""
        return (boot, seq) > self._newest

    def accept(self, boot: int, seq: int) -> bool:
        """Accept a new frame; False while the number on the disk does not allow it."""
        allowed_boot, allowed_seq = self._allowed
        if boot != allowed_boot or seq + self._ahead // 2 > allowed_seq:
            self._wanted = boot, min(seq + self._ahead, LARGEST_SEQ)
            self._wake.set()
        if (boot, seq) > self._allowed:
            return False
        self._newest = boot, seq
        return True

    def close(self) -> None:
        """End the thread, and write the number of the newest frame; closing twice does no harm."""
        thread, self._thread = self._thread, None
        if thread is None:
            return
        self._ended = True
        self._wake.set()
        thread.join()
        self._try_to_write(self._newest)

    def _write_ahead(self) -> None:
        while True:
            self._wake.wait()
            self._wake.clear()
            if self._ended:
                return
            wanted = self._wanted
            if wanted is not None and wanted > self._allowed and self._try_to_write(wanted):
                self._allowed = wanted

    def _try_to_write(self, number: FrameNumber) -> bool:
        try:
            write_newest(self._file, number)
        except OSError as error:
            self.trouble = Text("shirtdev-newest-not-stored", why=error.strerror or error)
            return False
        self.trouble = None
        return True
