"""The patient's screen in a real browser: paired by its link, shown a drive, cut off, back again, and thanked."""

import re
from urllib.parse import urlsplit

import pytest
from api.test_roles import OPEN
from browser.driving import HIDE, SHOW, go_on_until, speed_in
from browser.served.restarted_clinic import RestartedClinic
from browser.sizes import keep
from browser.tablets import send
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

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


@pytest.fixture(params=["1280x800", "768x1024"])
def screens(request, own_demo, open_page):
    """Return the clinician's page, the patient's of one size, and a function that keeps a screenshot of a page."""
    clinician = open_page(own_demo, "1024x768")
    patient = open_page(f"{own_demo.split('#')[0]}icon.svg", request.param, has_touch=True)
    expect(clinician.get_by_role("heading", name="Where to?")).to_be_visible()
    return clinician, patient, lambda page, name: keep(page, f"{request.param}-{name}")


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
    go_on_until(clinician, lambda: speed_in(speed.inner_text()) >= 0.2, "a speed")
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
    wishes = {"arrow": True, "sounds": True, "large": True}
    assert send(clinician, clinician.url, "POST", "/patient-screen/settings", wishes).ok
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
    steps = send(clinician, base, "GET", "/calibration").json()["steps"]
    step = next(step["id"] for step in steps if step["joint"] == "right_elbow")
    assert send(clinician, base, "POST", f"/calibration/steps/{step}/start").ok
    words = patient.locator(".cue-words")
    expect(words).to_have_text("Bend your right elbow")
    # Letters of 12 mm can be read from 2 m; a tablet of 10 inches shows 5 pixels to a millimetre.
    assert float(words.evaluate("(one) => parseFloat(getComputedStyle(one).fontSize)")) * 0.7 / 5 >= 11
    keep(patient, "patient-cue")
    assert patient.evaluate(OUTSIDE) == []
    assert send(clinician, base, "POST", f"/calibration/steps/{step}/cancel").ok


def test_a_screen_is_paired_shown_the_drive_and_thanked(screens, own_demo):
    clinician, patient, keep = screens
    base = own_demo.split("/#")[0]
    pair(clinician, patient, keep)
    ask_for_arrow_and_sounds(clinician, patient)
    is_shown_the_drive(clinician, patient, keep)
    is_shown_the_stop(clinician, patient, keep)
    changes_nothing(clinician, patient, base)
    is_prompted(clinician, patient, keep, base)
    assert send(clinician, base, "DELETE", "/session").ok
    expect(patient.get_by_role("heading", name="Thank you")).to_be_visible()
    keep(patient, "patient-thanks")


def test_it_comes_back_when_the_program_was_away(browser, tmp_path, page_log):
    with RestartedClinic(tmp_path / "clinic") as clinic:
        log = page_log(clinic.base)
        page = log.watch(browser.new_page(viewport={"width": 640, "height": 480}))
        page.goto(clinic.link_of_a_screen())
        expect(page.locator(".task", has_text=WAITS)).to_be_visible()
        canvas = page.frame_locator("iframe").locator("canvas").first
        expect(canvas).to_be_visible()
        clinic.end()
        lost = page.get_by_text(LOST)
        expect(lost).to_be_visible()
        expect(page.locator(".task", has_text=WAITS)).to_be_hidden()
        keep(page, "patient-lost")
        clinic.begin()
        expect(lost).to_be_hidden()
        expect(page.locator(".task", has_text=WAITS)).to_be_visible()
        expect(canvas).to_be_visible()
        assert "Heron" not in page.content()
        assert log.outside == []
        page.close()


def test_a_wrong_link_says_what_to_do_and_an_unpaired_screen_shows_nothing(browser, own_demo):
    clinician, page = browser.new_page(), browser.new_page()
    page.goto(f"{own_demo.split('#')[0]}patient.html#pair=wrong")
    expect(page.get_by_role("heading", name="Pair this screen")).to_be_visible()
    expect(page.get_by_text("ask for a new one")).to_be_visible()
    clinician.goto(own_demo)
    expect(clinician.get_by_role("heading", name="Where to?")).to_be_visible()
    clinician.goto(f"{own_demo.split('#')[0]}#/settings")
    expect(clinician.get_by_role("heading", name="Settings")).to_be_visible()
    card = card_of(clinician)
    card.get_by_role("button", name="Pair a screen").click()
    link = card.locator("code").inner_text()
    page.evaluate("(hash) => { location.hash = hash; }", urlsplit(link).fragment)  # scanned into the page that is open
    expect(page.locator(".task", has_text=WAITS)).to_be_visible()
    expect(card.get_by_text("connected", exact=True)).to_be_visible()
    keep(clinician, "patient-screen-settings")
    card.get_by_role("button", name="Unpair screen 1").click()
    expect(page.get_by_role("heading", name="This screen is not in use")).to_be_visible()
    expect(page.locator("iframe")).to_have_count(0)
    expect(card.get_by_text("Screen 1")).to_have_count(0)
