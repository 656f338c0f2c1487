"""A WHILL at the end of a pseudo-terminal, in a thread, for a receiver's process."""

import os
import pty
import select
import threading
from contextlib import suppress

from hardware.chair.far_ends import WhillChair

from app.clock import monotonic


class WhillOnALine(WhillChair):
    """A WHILL that answers over `device` until it is closed."""

    def __init__(self):
        super().__init__()
        self._line, self._far = pty.openpty()
        os.set_blocking(self._line, False)
        self.device = os.ttyname(self._far)
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    def close(self):
        self._ending.set()
        self._thread.join()
        os.close(self._line)
        os.close(self._far)

    def _run(self):
        received = b""
        while not self._ending.is_set():
            with suppress(OSError):
                if select.select([self._line], [], [], 0.005)[0]:
                    received += os.read(self._line, 4096)
            while len(received) > 1 and len(received) >= (size := received[1] + 2):
                self.take(received[:size], monotonic())
                received = received[size:]
            with suppress(OSError):
                os.write(self._line, self.sent(monotonic()))
