"""The patient's screen in a real browser: paired by its link, shown a drive, cut off, back again, and thanked."""

import math
import re
import signal
from urllib.parse import urlsplit

import pytest
from api.test_roles import OPEN
from browser.driving import HIDE, SHOW, go_on_until
from browser.tablets import headers_of
from playwright.sync_api import expect
from processes.served_demo import SessionClient, bodydrive, free_port, printed_link, running_demo

from folders import SCREENSHOTS

pytestmark = [pytest.mark.browser, pytest.mark.long]

SIZES = {"1280x800": (1280, 800), "768x1024": (768, 1024)}
LOST = "No connection to the program"
WAITS = re.compile("We wait for (your clinician|the shirt)")
# What sticks out of the window, or makes it scroll.
OUTSIDE = """() => {
  const page = document.documentElement;
  const shown = [...document.querySelectorAll(".patient .hud, .band, .btn")].filter((one) => one.checkVisibility());
  const out = shown.filter((one) => {
    const box = one.getBoundingClientRect();
    return box.left < 0 || box.top < 0 || box.right > innerWidth + 1 || box.bottom > innerHeight + 1;
  });
  const scrolls = page.scrollHeight > innerHeight || page.scrollWidth > innerWidth;
  return [...out.map((one) => one.className), ...(scrolls ? ["scrolls"] : [])];
}"""


@pytest.fixture
def demo():
    """Yield the link of a running demonstration."""
    with running_demo() as link:
        yield link


@pytest.fixture(params=SIZES)
def screens(request, browser, page_log, demo):
    """Yield the clinician's page, the patient's of one size, and a function that keeps a screenshot of a page."""
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    width, height = SIZES[request.param]
    log = page_log(demo)
    clinician = log.watch(browser.new_context(viewport={"width": 1024, "height": 768}).new_page())
    patient = log.watch(browser.new_context(viewport={"width": width, "height": height}, has_touch=True).new_page())
    clinician.goto(demo)
    expect(clinician.get_by_role("heading", name="Where to?")).to_be_visible()
    yield clinician, patient, lambda page, name: page.screenshot(path=SCREENSHOTS / f"{request.param}-{name}.png")
    log.assert_clean()
    for page in (clinician, patient):
        page.context.close()


def card_of(clinician):
    return clinician.locator("section.patient-screens")


def pair(clinician, patient, keep):
    clinician.get_by_role("link", name="The patient's screen").click()
    card = card_of(clinician)
    card.get_by_role("button", name="Pair a screen").click()
    expect(card.get_by_text("Only this machine can open the link")).to_be_visible()
    assert card.locator("img.qr").evaluate("(image) => image.naturalWidth") > 0
    card.scroll_into_view_if_needed()
    keep(clinician, "patient-screen-code")
    patient.goto(card.locator("code").inner_text())
    expect(patient.locator(".task", has_text=WAITS)).to_be_visible()
    assert urlsplit(patient.url).fragment == ""
    expect(card.get_by_text("Screen 1")).to_be_visible()
    expect(card.get_by_text("connected", exact=True)).to_be_visible()
    expect(card.locator("img.qr")).to_have_count(0)


def ask_for_arrow_and_sounds(clinician, patient):
    for wish in ("Arrow to the goal", "Sounds"):
        card_of(clinician).get_by_label(wish).check(force=True)
    sound = patient.get_by_role("button", name="Turn sound on")
    expect(sound).to_be_visible()
    assert sound.bounding_box()["height"] >= 44
    sound.tap()
    expect(sound).to_be_hidden()


def is_shown_the_drive(clinician, patient, keep):
    clinician.get_by_role("link", name="Back to the task").click()
    expect(clinician.get_by_role("navigation", name="What else")).to_contain_text("1 paired")
    clinician.get_by_role("button", name="Start trial").click()
    speed = patient.locator(".patient .speed .big")
    go_on_until(clinician, lambda: float(re.match(r"[\d.]+", speed.inner_text())[0]) >= 0.2, "a speed")
    go_on_until(clinician, patient.locator(".arrow svg").is_visible, "the arrow")
    go_on_until(clinician, patient.locator(".instruction").inner_text, "what is asked")
    expect(patient.frame_locator("iframe").locator("canvas").first).to_be_visible()
    assert patient.evaluate(OUTSIDE) == []
    keep(patient, "patient-drive")


def is_shown_the_stop(clinician, patient, keep):
    clinician.locator("#stop").dispatch_event("pointerdown")
    band = patient.locator(".band.stopped")
    expect(band).to_contain_text("Stopped")
    expect(band).to_contain_text("Stop was pressed on a clinician's page.We wait for your clinician to look")
    box = band.bounding_box()
    assert (box["x"], box["width"]) == (0, patient.viewport_size["width"])
    keep(patient, "patient-stopped")
    width, height = patient.viewport_size["width"], patient.viewport_size["height"]
    patient.set_viewport_size({"width": height, "height": width})
    expect(band).to_be_visible()
    patient.wait_for_timeout(300)
    assert patient.evaluate(OUTSIDE) == []
    patient.set_viewport_size({"width": width, "height": height})
    go_on_until(clinician, band.is_hidden, "the end of the stop")
    is_told_that_the_clinician_s_page_is_hidden(clinician, patient, keep)
    is_readable_in_the_dark_and_large(clinician, patient, keep)
    clinician.get_by_role("button", name="End trial").first.click()
    expect(patient.locator(".moment")).to_contain_text("Finished")


def is_told_that_the_clinician_s_page_is_hidden(clinician, patient, keep):
    band = patient.locator(".band.stopped")
    clinician.evaluate(HIDE)
    expect(clinician.get_by_role("heading", name="Paused")).to_be_visible()
    expect(band).to_be_hidden()  # nobody has stopped anything, and nobody has to go on
    keep(patient, "patient-hidden")
    clinician.evaluate(SHOW)
    expect(clinician.get_by_role("heading", name="Paused")).to_be_hidden()


def is_readable_in_the_dark_and_large(clinician, patient, keep):
    calls, base = clinician.context.request, clinician.url.split("/#")[0].rstrip("/")
    wishes = {"arrow": True, "sounds": True, "large": True}
    assert calls.post(f"{base}/api/v1/patient-screen/settings", data=wishes, headers=headers_of(calls, base)).ok
    patient.emulate_media(color_scheme="dark", reduced_motion="reduce")
    expect(patient.locator("html.large")).to_have_count(1)
    go_on_until(clinician, patient.locator(".instruction").is_visible, "what is asked")
    patient.wait_for_timeout(500)
    assert patient.evaluate(OUTSIDE) == []
    keep(patient, "patient-large-dark")


def changes_nothing(clinician, patient, base):
    """Try every call that changes something with the cookie of this screen."""
    calls = patient.context.request
    paths = clinician.context.request.get(f"{base}/api/v1/openapi.json").json()["paths"]
    tried = 0
    for path, methods in paths.items():
        for method in set(methods) - {"get"}:
            if (method.upper(), path) in OPEN:
                continue
            url = base + re.sub(r"\{\w+\}", "1", path.replace("{role}", "patient"))
            answer = calls.fetch(url, method=method.upper(), headers={"Origin": base}, data={})
            assert answer.status == 401, (method, path, answer.status)
            tried += 1
    assert tried >= 30


def is_prompted(clinician, patient, keep, base):
    calls, ours = clinician.context.request, headers_of(clinician.context.request, base)
    steps = calls.get(f"{base}/api/v1/calibration").json()["steps"]
    step = next(step["id"] for step in steps if step["joint"] == "right_elbow")
    assert calls.post(f"{base}/api/v1/calibration/steps/{step}/start", headers=ours).ok
    words = patient.locator(".cue-words")
    expect(words).to_have_text("Bend your right elbow")
    # Letters of 12 mm can be read from 2 m; a tablet of 10 inches shows 5 pixels to a millimetre.
    assert float(words.evaluate("(one) => parseFloat(getComputedStyle(one).fontSize)")) * 0.7 / 5 >= 11
    keep(patient, "patient-cue")
    assert patient.evaluate(OUTSIDE) == []
    assert calls.post(f"{base}/api/v1/calibration/steps/{step}/cancel", headers=ours).ok


def test_a_screen_is_paired_shown_the_drive_and_thanked(screens, demo):
    clinician, patient, keep = screens
    base = demo.split("/#")[0]
    pair(clinician, patient, keep)
    ask_for_arrow_and_sounds(clinician, patient)
    is_shown_the_drive(clinician, patient, keep)
    is_shown_the_stop(clinician, patient, keep)
    changes_nothing(clinician, patient, base)
    is_prompted(clinician, patient, keep, base)
    calls = clinician.context.request
    assert calls.delete(f"{base}/api/v1/session", headers=headers_of(calls, base)).ok
    expect(patient.get_by_role("heading", name="Thank you")).to_be_visible()
    keep(patient, "patient-thanks")


def served(port, state):
    return bodydrive("serve", "--port", str(port), "--state", str(state))


def test_it_comes_back_when_the_program_was_away(browser, tmp_path, page_log):
    port, state = free_port(), tmp_path / "clinic"
    process = served(port, state)
    try:
        base, code = printed_link(process).split("/#setup=")
        with SessionClient(base) as client:
            client.post("/auth/setup", json={"code": code, "name": "Ada", "password": "correct horse battery"})
            patient_id = client.post("/patients", json={"code": "P-1", "pseudonym": "Heron"}).json()["id"]
            assert client.post("/session", json={"patient_id": patient_id}).is_success
            link = client.post("/patient-screen/pairing").json()["url"]
        log = page_log(base)
        page = log.watch(browser.new_page(viewport={"width": 640, "height": 480}))
        page.goto(link)
        expect(page.locator(".task", has_text=WAITS)).to_be_visible()
        canvas = page.frame_locator("iframe").locator("canvas").first
        expect(canvas).to_be_visible()
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        lost = page.get_by_text(LOST)
        expect(lost).to_be_visible()
        expect(page.locator(".task", has_text=WAITS)).to_be_hidden()
        page.screenshot(path=SCREENSHOTS / "patient-lost.png")
        process = served(port, state)
        printed_link(process)
        expect(lost).to_be_hidden()
        expect(page.locator(".task", has_text=WAITS)).to_be_visible()
        expect(canvas).to_be_visible()
        assert "Heron" not in page.content()
        assert log.outside == []
        page.close()
    finally:
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)


def test_a_wrong_link_says_what_to_do_and_an_unpaired_screen_shows_nothing(browser, demo):
    clinician, page = browser.new_context().new_page(), browser.new_context().new_page()
    page.goto(f"{demo.split('#')[0]}patient.html#pair=wrong")
    expect(page.get_by_role("heading", name="Pair this screen")).to_be_visible()
    expect(page.get_by_text("ask for a new one")).to_be_visible()
    clinician.goto(demo)
    expect(clinician.get_by_role("heading", name="Where to?")).to_be_visible()
    clinician.goto(f"{demo.split('#')[0]}#/settings")
    expect(clinician.get_by_role("heading", name="Settings")).to_be_visible()
    card = card_of(clinician)
    card.get_by_role("button", name="Pair a screen").click()
    link = card.locator("code").inner_text()
    page.evaluate("(hash) => { location.hash = hash; }", urlsplit(link).fragment)  # scanned into the page that is open
    expect(page.locator(".task", has_text=WAITS)).to_be_visible()
    expect(card.get_by_text("connected", exact=True)).to_be_visible()
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    clinician.screenshot(path=SCREENSHOTS / "patient-screen-settings.png")
    card.get_by_role("button", name="Unpair screen 1").click()
    expect(page.get_by_role("heading", name="This screen is not in use")).to_be_visible()
    expect(page.locator("iframe")).to_have_count(0)
    expect(card.get_by_text("Screen 1")).to_have_count(0)
    for one in (clinician, page):
        one.context.close()


def test_the_arrow_and_the_sounds_mean_what_happens(browser, demo):
    page = browser.new_page()
    page.goto(f"{demo.split('#')[0]}patient.html")
    expect(page.get_by_role("heading", name="Pair this screen")).to_be_visible()
    arrow = """([pose, target]) => import("/js/patient/arrow.js").then(({ bearingTo, side }) => {
      const { bearing, distance } = bearingTo(pose, target);
      return [bearing, distance, side(bearing)];
    })"""
    quarter = math.pi / 2
    for pose, target, bearing, where in (
        ([0, 0, 0], [2, 0], 0, "ahead"),
        ([0, 0, 0], [0, 2], quarter, "left"),
        ([0, 0, quarter], [2, 0], -quarter, "right"),
        ([1, 1, quarter], [1, 3], 0, "ahead"),
        ([0, 0, 3.0], [-2 * math.cos(3.0), -2 * math.sin(3.0)], math.pi, "behind"),
        ([0, 0, 4 * math.pi + 0.1], [2, 0], -0.1, "ahead"),
    ):
        found = page.evaluate(arrow, [pose, target])
        assert math.cos(found[0] - bearing) == pytest.approx(1), (pose, target)
        assert found[1:] == [pytest.approx(2), where]
    between = """([before, now]) => import("/js/patient/sounds.js")
        .then(({ soundsBetween }) => soundsBetween(before, now))"""
    still = {"state": "armed", "contacts": 1, "trial": {"id": 1}, "over": None}
    over = {**still, "trial": None, "over": {"id": 1, "end": "goal"}}
    for before, now, sounds in (
        (None, {**still, "state": "fault"}, []),
        (still, still, []),
        (still, {**still, "contacts": 2}, ["contact"]),
        (still, {**still, "contacts": 5, "trial": {"id": 2}}, []),
        (still, {**still, "state": "fault"}, ["stop"]),
        ({**still, "state": "fault"}, {**still, "state": "fault"}, []),
        (still, over, ["goal"]),
        (over, over, []),
        (still, {**over, "over": {"id": 1, "end": "by hand"}}, []),
    ):
        assert page.evaluate(between, [before, now]) == sounds, (before, now)
    page.close()
