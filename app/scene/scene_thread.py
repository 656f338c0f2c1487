"""The thread that updates the scene with the newest tick: often while a page shows it, otherwise seldom."""

import threading
from collections.abc import Callable
from pathlib import Path
from typing import Final

import numpy as np

from app.clock import MonotonicClock
from app.scene.role_servers import RoleServers
from app.scene.session_scene import LiveScene

UPDATE_EVERY: Final = 1 / 60  # s, while a page shows the scene
STAMP_EVERY: Final = 0.1  # s; also between two updates that no page shows: the trajectory is followed all the same

ReadNewest = Callable[[], "np.void | None"]


class SceneThread:
    """A scene and the thread that updates it with the newest tick; `stop` ends the thread, not the servers."""

    def __init__(self, scene: LiveScene, read_newest: ReadNewest) -> None:
        self.scene = scene
        self._read_newest = read_newest
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="scene", daemon=True)

    def start(self) -> None:
        """Start the thread."""
        self._thread.start()

    def stop(self) -> None:
        """End the thread and wait for its end; a second call does nothing."""
        self._ended.set()
        if self._thread.is_alive():
            self._thread.join()

    def _run(self) -> None:
        clock = MonotonicClock()
        number, moved_at = -1, clock.now()
        deadline = stamp_at = clock.now()
        while not self._ended.is_set():
            tick = self._read_newest()
            now = clock.now()
            if tick is not None and int(tick["number"]) != number:
                number, moved_at = int(tick["number"]), now
                self.scene.follow(tick)
            if now >= stamp_at:
                self.scene.send_time(now, now - moved_at)
                stamp_at = now + STAMP_EVERY
            # A late update is skipped: the next deadline is counted from now.
            pause = UPDATE_EVERY if self.scene.is_watched else STAMP_EVERY
            deadline = max(deadline + pause, clock.now())
            self._ended.wait(max(deadline - clock.now(), 0.0))


def start_scene(servers: RoleServers, read_newest: ReadNewest, models: Path | None = None) -> SceneThread:
    """Draw the scene on the servers and update it with the newest tick; stop the thread before the servers."""
    thread = SceneThread(LiveScene(servers, models), read_newest)
    thread.start()
    return thread
