"""The view's buttons, gestures and settings in a real browser, in front of a stand-in for the server."""

import mimetypes
from itertools import pairwise

import pytest
from browser.script import SCRIPTS
from browser.sizes import window
from served_reference import served_reference

from app.settings import static_folder

pytestmark = [pytest.mark.browser, pytest.mark.long]

ORIGIN = "http://127.0.0.1:9"  # nothing listens there: every answer comes from the test
PAGE = (SCRIPTS / "view_bar.html").read_text(encoding="utf-8")


CLINICIANS = "posts.findLast(({ path }) => path === '/view/clinician/camera').body"
PATIENTS = "posts.findLast(({ path }) => path === '/view/patient/camera').body"


@pytest.fixture(scope="module")
def reference():
    return served_reference()


def answer(route, reference):
    path = route.request.url.removeprefix(ORIGIN)
    if path == "/":
        route.fulfill(body=PAGE, content_type="text/html")
    elif path == "/api/v1/reference":
        route.fulfill(body=reference, content_type="application/json")
    else:
        file = static_folder() / path.lstrip("/")
        route.fulfill(body=file.read_bytes(), content_type=mimetypes.guess_type(file.name)[0] or "text/plain")


@pytest.fixture
def open_bar(browser, page_log, until, reference):
    log = page_log(ORIGIN)

    def opened(**options):
        page = log.watch(browser.new_page(in_3d=True, viewport=window("768x1024"), **options))
        page.route(f"{ORIGIN}/**", lambda route: answer(route, reference))
        page.goto(f"{ORIGIN}/")
        until(page, "window.ready && posts.length > 1")
        return page

    yield opened
    log.assert_clean()


def posts(page, ending):
    return [post for post in page.evaluate("() => posts") if post["path"].endswith(ending)]


def free_view(page, until):
    page.get_by_text("Free", exact=True).click()
    until(page, "!document.querySelector('.surface').hidden")


def settled(page, until, condition):
    """Wait for the newest place of the camera to be as expected."""
    until(page, f"(({{ azimuth, elevation, distance, x, y }}) => {condition})(posts.at(-1).body)")


def test_the_pad_is_there_in_the_free_view_only_and_its_buttons_are_large_enough(open_bar, until):
    page = open_bar()
    assert posts(page, "/clinician/camera")[0]["body"]["view"] == "eye"
    assert not page.locator(".free-pad").is_visible()
    free_view(page, until)
    for button in page.locator(".free-pad button").all():
        box = button.bounding_box()
        assert min(box["width"], box["height"]) >= 44
    page.get_by_role("button", name="Turn right").click()
    settled(page, until, "azimuth > 0.1 && distance === 10")
    page.get_by_role("button", name="Higher").click()
    settled(page, until, "elevation > 0.6")
    page.get_by_role("button", name="Nearer").click()
    settled(page, until, "distance < 9")
    page.get_by_text("Top", exact=True).click()
    until(page, "document.querySelector('.surface').hidden")
    assert posts(page, "/clinician/camera")[-1]["body"]["view"] == "top"


def test_the_drawn_plan_is_a_view_of_the_page_alone(open_bar, until):
    page = open_bar()
    before = len(posts(page, "/clinician/camera"))
    page.get_by_text("Plan", exact=True).click()
    until(page, "chosen === 'plan'")
    page.get_by_text("Chase", exact=True).click()
    until(page, f"chosen === 'view' && {CLINICIANS}.view === 'chase'")
    assert len(posts(page, "/clinician/camera")) == before + 1


def test_a_drag_turns_a_wheel_comes_nearer_and_keys_do_both(open_bar, until):
    page = open_bar()
    free_view(page, until)
    page.mouse.move(300, 300)
    page.mouse.down()
    page.mouse.move(400, 350, steps=5)
    page.mouse.up()
    settled(page, until, "azimuth < -0.4 && elevation > 0.6")
    page.mouse.wheel(0, 200)
    settled(page, until, "distance > 11")
    page.locator(".surface").focus()
    page.keyboard.press("+")
    page.keyboard.press("+")
    settled(page, until, "distance < 11")
    page.keyboard.press("Shift+ArrowUp")
    settled(page, until, "Math.hypot(x, y) > 0.3")
    page.keyboard.press("ArrowDown")
    settled(page, until, "elevation < 0.75")


def test_many_movements_are_few_messages_and_the_last_is_the_newest(open_bar, until):
    page = open_bar()
    free_view(page, until)
    page.mouse.move(200, 300)
    page.mouse.down()
    page.mouse.move(500, 300, steps=150)
    page.mouse.up()
    settled(page, until, "Math.abs(azimuth + 1.8) < 1e-6")
    sent = posts(page, "/free")
    assert len(sent) < 150
    gaps = [later["at"] - earlier["at"] for earlier, later in pairwise(sent)]
    assert min(gaps, default=50) >= 45


def test_settings_are_sent_and_remembered(open_bar, until):
    page = open_bar()
    page.get_by_role("button", name="The eye’s settings").click()
    page.get_by_role("button", name="Field of view +").click()
    until(page, f"{CLINICIANS}.fov_deg === 70 && {PATIENTS}.fov_deg === 70")
    page.get_by_role("button", name="Tilt of the head +").click()
    until(page, f"{CLINICIANS}.roll_share === 0.25 && {PATIENTS}.roll_share === 0.25")
    page.get_by_role("switch").click()
    until(page, f"{CLINICIANS}.head === false && {PATIENTS}.head === false")
    assert "view" not in posts(page, "/patient/camera")[-1]["body"]
    page.reload()
    until(page, "window.ready && posts.length > 0")
    assert posts(page, "/clinician/camera")[0]["body"] == {
        "view": "eye",
        "fov_deg": 70,
        "eye_height": 1.2,
        "roll_share": 0.25,
        "head": False,
    }


def test_who_asks_for_reduced_motion_gets_no_tilt(open_bar):
    page = open_bar(reduced_motion="reduce")
    page.evaluate("localStorage.setItem('bodydrive-eye', JSON.stringify({ roll_share: 1 }))")
    page.reload()
    page.wait_for_function("window.ready && posts.length > 0")
    assert posts(page, "/clinician/camera")[0]["body"]["roll_share"] == 0
    assert page.get_by_role("button", name="Tilt of the head +").count() == 0
