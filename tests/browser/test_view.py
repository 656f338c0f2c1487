"""The 3D view in a real browser: each point that leans on the inside of viser 1.1.1 has its guard here."""

import io
import math
from contextlib import suppress

import numpy as np
import pytest
from browser.served.view_app import running
from PIL import Image

from app.scene.cameras import VIEWS
from app.scene.meshes import palette
from app.world.floorplan import bundled_floorplans, load_floorplan

PANEL = "document.querySelector('[data-floating-window]:has(.uplot)')"
# How many points of the first plot are red: the driven trajectory.
RED_POINTS = """[...document.querySelectorAll(".uplot canvas")].filter((c) => c.width > 0).slice(0, 1).map((c) => {
    const p = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
    return Array.from({length: p.length / 4}, (_, i) => 4 * i)
        .filter((i) => p[i] > 150 && p[i + 1] < 90 && p[i + 2] < 90 && p[i + 3] > 200).length;
})[0]"""

pytestmark = pytest.mark.browser

SIZES = {"tablet on its side": (1024, 768), "tablet upright": (820, 1180)}
SMALL = (640, 480)
FIRST_PICTURE = 30  # s; the application, too, loads the view anew when its first picture does not come
LOADS = 4
# Far above the second after which a page speaks up: software may need seconds for one picture on a busy machine.
LIVE = "document.documentElement.dataset.scene === '' && window.bodydriveView.age() < 20"


@pytest.fixture(scope="module")
def app():
    with running(load_floorplan(bundled_floorplans()["clinic"])) as served:
        yield served


@pytest.fixture(scope="module")
def log(app, page_log):
    return page_log(app.address)


@pytest.fixture(scope="module")
def open_view(app, browser, log, until):
    def opened(size, role="clinician"):
        page = log.watch(browser.new_page(viewport=dict(zip(("width", "height"), size, strict=True))))
        for _ in range(LOADS):
            page.goto(f"{app.address}/view/{role}/")
            with suppress(AssertionError):
                until(page, LIVE, seconds=FIRST_PICTURE)
                return page
        raise AssertionError(f"no picture after {LOADS} loads; the page reported {log.errors}")

    return opened


@pytest.fixture(scope="module")
def small_page(open_view):
    """One page for all that does not depend on its size: software draws few pixels faster."""
    page = open_view(SMALL)
    yield page
    page.close()


@pytest.fixture
def page(app, small_page):
    yield small_page
    app.ride.held_at = None
    app.ride.head = (math.nan, math.nan, math.nan)
    app.scene_thread.scene.open_plots(False)
    app.scene_thread.scene.set_view("clinician", "eye")


def picture(page):
    return np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), dtype=np.float64)


def test_on_a_tablet_every_view_draws_a_bright_picture_and_the_plots_leave_most_of_it(app, open_view, log, until):
    """In one page: software loads a large view, and draws it for as long as it is open, at the cost of other tests."""
    page = open_view(SIZES["tablet on its side"])
    every_view_draws_a_bright_picture(app, page, until)
    the_plots_are_closed_until_asked_for_and_leave_most_of_the_picture(app, page, until)
    log.assert_clean()
    page.close()


def every_view_draws_a_bright_picture(app, page, until):
    app.ride.held_at = 6.0
    for size, (width, height) in SIZES.items():
        page.set_viewport_size({"width": width, "height": height})
        until(page, f"document.querySelector('canvas[data-engine]').getBoundingClientRect().width === {width}")
        seen = {}
        for view in VIEWS:
            answer = page.request.post(f"{app.address}/api/v1/view/clinician/camera", data={"view": view})
            assert (answer.json()["view"], answer.json()["plots"]) == (view, False)
            fov = {"eye": 68, "chase": 50, "top": 30, "free": 50}[view]
            until(page, f"Math.abs(window.__viserMutable.camera.fov - {fov}) < 0.5")
            page.wait_for_timeout(600)
            seen[view] = picture(page)
            assert 120 < seen[view].mean() < 250, (size, view)
            assert seen[view].std() > 15, (size, view)
        assert np.abs(seen["eye"] - seen["chase"]).mean() > 5, size
        assert np.abs(seen["chase"] - seen["top"]).mean() > 5, size
    app.ride.held_at = None
    app.scene_thread.scene.set_view("clinician", "eye")


def the_plots_are_closed_until_asked_for_and_leave_most_of_the_picture(app, page, until):
    page.set_viewport_size({"width": 1024, "height": 768})
    until(page, "document.querySelector('canvas[data-engine]').getBoundingClientRect().width === 1024")
    assert not page.evaluate(f"() => !!{PANEL}")
    answer = page.request.post(f"{app.address}/api/v1/view/clinician/plots", data={"open": True})
    assert answer.json()["plots"] is True
    until(page, f"{PANEL} && {PANEL}.checkVisibility() && {RED_POINTS} > 20")
    box = page.evaluate(f"() => {{ const b = {PANEL}.getBoundingClientRect(); return [b.width, b.height, b.right]; }}")
    assert box[0] * box[1] < 0.2 * 1024 * 768
    assert box[2] <= 1024
    canvas = page.evaluate("() => document.querySelector('canvas[data-engine]').getBoundingClientRect().width")
    assert canvas == 1024
    page.request.post(f"{app.address}/api/v1/view/clinician/plots", data={"open": False})
    until(page, f"!{PANEL} || !{PANEL}.checkVisibility()")


def test_the_plan_fills_the_picture_from_above(app, page, until):
    app.scene_thread.scene.set_view("clinician", "top")
    until(page, "Math.abs(window.__viserMutable.camera.fov - 30) < 0.5")
    page.wait_for_timeout(800)
    shot = picture(page)
    background = np.abs(shot[240] - shot[2].mean(axis=0)).max(axis=1) < 12
    assert background.mean() < 0.1


def test_a_room_has_its_own_colours_and_a_ceiling_for_the_eye_only(app, page, until):
    app.ride.held_at = 4.0

    def share(colour):
        return float((np.abs(picture(page) - colour).max(axis=2) <= 3).mean())

    for view, fov in (("eye", 68), ("top", 30)):
        app.scene_thread.scene.set_view("clinician", view)
        until(page, f"Math.abs(window.__viserMutable.camera.fov - {fov}) < 0.5")
        page.wait_for_timeout(800)
        assert share(palette.FLOOR) > 0.02, view
        assert share(palette.FLOOR_TILE) > 0.02, view
        assert (share(palette.CEILING) > 0.004) == (view == "eye")


def test_nothing_of_visers_own_panel_can_be_seen(page):
    seen = page.evaluate("""() => [...document.querySelectorAll("body *")]
        .filter((element) => element.checkVisibility() && element.getBoundingClientRect().width > 0)
        .filter((element) => !element.querySelector("canvas") && element.tagName !== "CANVAS")
        .map((element) => element.outerHTML.slice(0, 80))""")
    assert seen == []
    assert page.evaluate("document.body.innerText.trim()") == ""


def test_the_picture_cannot_be_turned_by_hand_or_key(page, until):
    until(page, "window.__viserMutable.cameraControl.enabled === false")
    where = "JSON.stringify(window.__viserMutable.camera.matrixWorld.elements)"
    before = page.evaluate(f"() => {where}")
    page.mouse.move(300, 250)
    page.mouse.down()
    page.mouse.move(450, 200, steps=3)
    page.mouse.up()
    page.mouse.wheel(0, 400)
    page.keyboard.down("w")
    page.wait_for_timeout(400)
    page.keyboard.up("w")
    assert page.evaluate(f"() => {where}") == before


def test_the_world_is_where_the_chair_is(app, page, until):
    app.ride.held_at = 4.0
    pose = app.ride.pose(4.0)
    until(page, f"Math.abs(window.__viserMutable.nodePoseData['/world/chair'].position[0] - {pose.x}) < 1e-3")
    # The camera must not have moved from the origin of viser's world, whatever the chair did.
    assert page.evaluate("() => window.__viserMutable.camera.position.length()") < 1e-3


def test_the_head_turns_the_picture_and_a_lost_one_eases_back(app, page, until):
    app.ride.held_at = 4.0
    page.wait_for_timeout(500)
    turned = "window.__viserMutable.nodePoseData['/world'].wxyz"
    before = page.evaluate(f"() => {turned}")
    app.ride.head = (0.8, 0.1, 0.0)
    until(page, f"Math.abs({turned}[3] - {before[3]}) > 0.2")
    app.ride.head = (math.nan, math.nan, math.nan)
    until(page, f"Math.hypot(...{turned}.map((value, i) => value - {before}[i])) < 1e-3")


def test_the_free_camera_is_put_by_the_server(app, page, until):
    where = "JSON.stringify(window.__viserMutable.nodePoseData['/world'].position)"
    api = f"{app.address}/api/v1/view/clinician"
    page.request.post(f"{api}/camera", data={"view": "free"})
    page.wait_for_timeout(600)
    before = page.evaluate(f"() => {where}")
    place = {"azimuth": 1.0, "elevation": 0.7, "distance": 6.0, "x": 2.0, "y": 3.0}
    page.request.post(f"{api}/free", data=place)
    until(page, f"{where} !== {before!r}")
    assert page.evaluate("() => window.__viserMutable.camera.position.length()") < 1e-3


def test_the_page_tells_how_old_the_drawn_pose_is(page, until):
    until(page, "window.bodydriveView.lag() >= 0 && window.bodydriveView.lag() < 20")


def test_a_patient_sees_no_plots(app, open_view, page):
    app.scene_thread.scene.open_plots(True)
    patients = open_view(SMALL, role="patient")
    assert not patients.evaluate("() => !!document.querySelector('.uplot')")
    patients.close()


def test_a_picture_that_stands_still_says_so(app, page, until):
    app.scene_thread.stop()
    until(page, "window.bodydriveView.age() > 2")
    app.scene_thread.scene.send_time(12.5, 77.0)
    until(page, "window.bodydriveView.tickAge() === 77")
