"""The thread that lets the scene follow the newest tick."""

import pytest
from scene.scene_messages import messages, tick

from app.clock import MonotonicClock
from app.scene.scene_thread import SceneThread, start_scene
from app.scene.session_scene import CLOCK_NODE, LiveScene


def test_the_thread_follows_the_newest_tick_and_stamps_the_picture(servers):
    box = [tick(1, 1.0, 1.0, 0.0)]
    thread = start_scene(servers, lambda: box[0])
    try:
        box[0] = tick(2, 5.0, 4.0, 0.0)
        messages(
            servers.port("clinician"),
            lambda message: (
                message["type"] == "SetPositionMessage"
                and message["name"] == "/world/chair"
                and message["position"][0] == pytest.approx(5.0)
            ),
        )
        stamps = set()

        def third_stamp(message):
            if message["type"] == "SetPositionMessage" and message["name"] == CLOCK_NODE:
                stamps.add(message["position"][0])
            return len(stamps) >= 3

        messages(servers.port("clinician"), third_stamp)
    finally:
        thread.stop()
    thread.stop()


def test_the_same_tick_is_drawn_once(servers):
    drawn, asked = [], []

    def newest():
        asked.append(None)
        return tick(7, 1.0, 1.0, 0.0)

    thread = start_scene(servers, newest)
    follow = thread.scene.follow
    thread.scene.follow = lambda found: (drawn.append(int(found["number"])), follow(found))
    clock = MonotonicClock()
    while len(asked) < 10:
        clock.sleep_until(clock.now() + 0.01)
    thread.stop()
    assert len(drawn) <= 1


class CountedScene:
    """Stands for a scene, and counts the time stamps that it is asked to send."""

    def __init__(self, *, is_watched):
        self.is_watched = is_watched
        self.stamps = 0

    def follow(self, found):
        pass

    def send_time(self, *_):
        self.stamps += 1


@pytest.mark.parametrize("is_watched", [True, False])
def test_a_scene_that_no_page_shows_is_updated_as_seldom_as_its_clock(is_watched):
    scene, asked = CountedScene(is_watched=is_watched), []
    thread = SceneThread(scene, lambda: asked.append(None))
    thread.start()
    clock = MonotonicClock()
    while scene.stamps < 4 or (is_watched and len(asked) <= 2 * scene.stamps + 1):
        clock.sleep_until(clock.now() + 0.01)
    thread.stop()
    assert is_watched or len(asked) <= 2 * scene.stamps + 1


def test_a_scene_is_watched_while_a_page_shows_it(servers):
    scene = LiveScene(servers)
    assert not scene.is_watched
    servers["patient"].get_clients = lambda: {0: object()}
    assert scene.is_watched
