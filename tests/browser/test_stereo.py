"""The stereo page in a real browser: the parallax of two eyes by geometry, and who may open it."""

import io
import math

import numpy as np
import pytest
from browser.eyes.sweep import small_targets
from browser.served.restarted_clinic import RestartedClinic
from browser.served.view_app import Running
from browser.sizes import ARE_KEPT, each_size, keep
from PIL import Image
from playwright.sync_api import expect

from app.api.pages import Pages
from app.geometry import Pose
from app.scene.cameras import EYE_BACK, EYE_DOWN, EyeSettings
from app.settings import static_folder
from app.world.floorplan import FloorPlan
from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser, pytest.mark.long]

WIDTH, HEIGHT = 1000, 600
APART = 0.08  # m
PILLAR_AT = 1.5  # m, its front
DEPTH = (PILLAR_AT + EYE_BACK) / math.cos(EYE_DOWN)  # m along the camera's axis, in the middle row
FOCAL = HEIGHT / 2 / math.tan(math.radians(EyeSettings().fov_deg) / 2)  # pixels
TOLERANCE = 2.0  # pixels: a slow machine draws with larger ones
LIVE = """[...document.querySelectorAll("iframe")].filter((one) => one.contentWindow.bodydriveView?.age() < 20).length
    === 2"""
CAMERAS = """() => [...document.querySelectorAll("iframe")].map((one) => {
    const { camera } = one.contentWindow.__viserMutable;
    return [camera.matrixWorld.elements[12], camera.filmOffset / camera.getFilmWidth()];
})"""
# Both pictures are drawn with pixels of one size; each of them becomes coarser by itself while it is slow.
EQUALLY_COARSE = """new Set([...document.querySelectorAll("iframe")]
    .map((one) => getComputedStyle(one).getPropertyValue("--coarse"))).size === 1"""
AWAY = "document.querySelector('.stereo').classList.add('is-quiet')"


def plan():
    """A pillar ahead of the chair, and a path that lies behind its back."""
    pillar = {"kind": "box", "label": "Pillar", "position": (PILLAR_AT + 0.15, 0.0), "size": (0.3, 0.3), "height": 2.0}
    path = {"name": "main", "title": "Main", "points": [(-3.0, 0.0), (-6.0, 0.0)], "instruction": "Drive ahead."}
    document = {"name": "pillar", "title": "Pillar", "walls": [], "obstacles": [pillar], "paths": [path]}
    return FloorPlan.model_validate(document)


@pytest.fixture(scope="module")
def app():
    served = Running(plan())
    served.app.mount("/", Pages(static_folder()))
    with served:
        yield served


@pytest.fixture(scope="module")
def log(app, page_log):
    return page_log(app.address)


@pytest.fixture(scope="module")
def open_page(app, browser, log, until):
    """One page for all: loading takes most of the time."""
    page = log.watch(browser.new_page(all_pictures=True, viewport={"width": WIDTH, "height": HEIGHT}))
    page.goto(f"{app.address}/stereo.html")
    page.evaluate("localStorage.setItem('bodydrive-stereo', '{\"apart\": 80}')")
    page.reload()
    until(page, LIVE)
    # The view shows the start of the path until the chair moves. It has moved, and stands before the pillar now.
    app.ride.pose = lambda _: Pose(0.0, 0.0, 0.0)
    yield page
    page.close()


@pytest.fixture
def page(open_page, log):
    yield open_page
    choose(open_page, "Side by side")
    show_bar(open_page)
    open_page.get_by_label("Swap left and right").uncheck(force=True)
    log.assert_clean()


def show_bar(page):
    page.mouse.move(300, 30)
    page.mouse.move(320, 30)


def choose(page, mode, screen="Infinity"):
    show_bar(page)
    page.get_by_text(mode, exact=True).click()
    show_bar(page)
    page.get_by_label("Screen distance", exact=True).select_option(screen)


def picture(page, name=None):
    """Return the whole page without its bar, when the cameras have been put and the picture drawn.

    With a name it is kept, where BODYDRIVE_PICTURES=1 asks for pictures.
    """
    page.mouse.move(300, 30)
    page.wait_for_timeout(1000)
    page.evaluate(AWAY)
    page.wait_for_timeout(1000)
    shot = page.screenshot(path=SCREENSHOTS / f"{name}.png" if name and ARE_KEPT else None)
    return np.asarray(Image.open(io.BytesIO(shot)).convert("RGB"), dtype=np.float64)


def pillar_in(half):
    """Return the column of the pillar's middle, around the middle row: only wood is browner than its surroundings."""
    rows = half[HEIGHT // 2 - 10 : HEIGHT // 2 + 10]
    brown = np.clip(rows[..., 0] - rows[..., 2] - 25, 0, 25).sum(axis=0)
    assert brown.max() > 0, "the pillar is not in the picture"
    return float(brown @ np.arange(len(brown)) / brown.sum())


def parallax(shot):
    """Return how much farther right the pillar is in the left half than in the right one, in pixels."""
    return pillar_in(shot[:, : WIDTH // 2]) - pillar_in(shot[:, WIDTH // 2 :])


def test_both_eyes_see_the_parallax_of_their_distance(page):
    expected = FOCAL * APART / DEPTH
    assert parallax(picture(page, "stereo-side")) == pytest.approx(expected, abs=TOLERANCE)
    choose(page, "Side by side", "1")
    assert parallax(picture(page)) == pytest.approx(expected - FOCAL * APART / 1.0, abs=TOLERANCE)
    choose(page, "Side by side")
    page.get_by_label("Swap left and right").check(force=True)
    assert parallax(picture(page)) == pytest.approx(-expected, abs=TOLERANCE)


def test_half_the_width_is_squeezed(page):
    choose(page, "Half width")
    assert parallax(picture(page, "stereo-squeezed")) == pytest.approx(FOCAL * APART / DEPTH / 2, abs=TOLERANCE)


def test_red_shows_the_left_eye_and_cyan_the_right(page):
    choose(page, "Red-cyan")
    shot = picture(page, "stereo-red-cyan")
    rows = shot[HEIGHT // 2 - 10 : HEIGHT // 2 + 10].mean(axis=0)

    def middle(channel):
        """Return the middle of the pillar, which is darker than the floor behind it."""
        around = rows[300:700, channel]
        dark = np.flatnonzero(around < (around.max() + around.min()) / 2)
        return 300 + (dark[0] + dark[-1]) / 2

    expected = FOCAL * APART / DEPTH
    assert middle(0) - middle(2) == pytest.approx(expected, abs=2 * TOLERANCE)
    assert middle(0) + middle(2) == pytest.approx(WIDTH, abs=2 * TOLERANCE)


def test_the_server_goes_on_to_set_the_field_of_view(app, page, until):
    fov = """[...document.querySelectorAll("iframe")].every((one) =>
        Math.abs(one.contentWindow.__viserMutable.camera.fov - {}) < 0.5)"""
    until(page, fov.format(68))
    scene = app.scene_thread.scene
    scene.set_view("patient", "eye", EyeSettings(fov_deg=50.0))
    until(page, fov.format(50))
    left, right = page.evaluate(CAMERAS)
    assert (left[0], right[0]) == (pytest.approx(-APART / 2), pytest.approx(APART / 2))
    scene.set_view("patient", "eye", EyeSettings())


def test_both_eyes_show_the_same_moment(app, page):
    app.ride.pose = lambda along: Pose(-0.3 * along, 0.0, 0.0)
    app.ride.held_at = None
    same, all_ = page.evaluate("""() => new Promise((done) => {
        const frames = [...document.querySelectorAll("iframe")];
        let same = 0, all = 0;
        const look = () => {
            const [a, b] = frames.map((one) => one.contentWindow.__viserMutable.nodePoseData["/world"].position);
            all += 1;
            same += Math.hypot(...a.map((value, i) => value - b[i])) < 0.03;
            if (all < 60) requestAnimationFrame(look); else done([same, all]);
        };
        look();
    })""")
    app.ride.held_at = 0.0
    app.ride.pose = lambda _: Pose(0.0, 0.0, 0.0)
    assert same / all_ > 0.8


def test_the_bar_stays_inside(page):
    bar = page.locator(".stereo-bar")
    for size in each_size(page, ("1280x800", "768x1024", "640x360")):
        show_bar(page)
        page.wait_for_timeout(600)
        keep(page, f"stereo-bar-{size}")
        expect(bar).to_be_in_viewport(ratio=1)
        assert bar.evaluate("(one) => one.scrollWidth <= innerWidth"), size
        assert small_targets(page, ".stereo-bar") == [], size


def test_without_a_distance_both_pictures_are_equal_and_it_is_remembered(page, until):
    show_bar(page)
    page.get_by_label("Swap left and right").focus()
    page.keyboard.press("Space")
    page.get_by_role("button", name="Eye distance −").focus()
    for _ in range(80):
        page.keyboard.press("Enter")
    page.evaluate(AWAY)
    page.keyboard.press("Tab")
    assert page.evaluate("!document.querySelector('.stereo').classList.contains('is-quiet')")
    page.reload()
    until(page, LIVE)
    show_bar(page)
    expect(page.get_by_label("Swap left and right")).to_be_checked()
    expect(page.get_by_text("0 mm", exact=True)).to_be_visible()
    until(page, EQUALLY_COARSE)
    shot = picture(page)
    while not page.evaluate(f"() => {EQUALLY_COARSE}"):
        until(page, EQUALLY_COARSE)
        shot = picture(page)
    assert shot.std() > 10
    assert abs(parallax(shot)) < 0.5
    assert np.abs(shot[:, : WIDTH // 2] - shot[:, WIDTH // 2 :]).mean() < 1.0
    assert page.evaluate(CAMERAS) == [pytest.approx([0, 0]), pytest.approx([0, 0])]


def test_a_paired_screen_sees_it_and_it_comes_back_by_itself(browser, tmp_path, page_log, until):
    with RestartedClinic(tmp_path / "clinic") as clinic:
        stereo = f"{clinic.base}/stereo.html"
        page = page_log(clinic.base).watch(browser.new_page(all_pictures=True, viewport={"width": 640, "height": 360}))
        page.goto(stereo)
        expect(page.get_by_role("heading", name="may not see")).to_be_visible()
        page.goto(clinic.link_of_a_screen())
        expect(page.get_by_text("We wait for the shirt")).to_be_visible()
        page.goto(stereo)
        until(page, LIVE, seconds=60)
        clinic.end()
        lost = page.get_by_text("No connection to the program")
        expect(lost).to_be_visible()
        clinic.begin()
        expect(lost).to_be_hidden()
        until(page, LIVE, seconds=60)
        page.close()
