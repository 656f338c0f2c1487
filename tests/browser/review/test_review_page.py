"""One trial and two side by side in a real browser: one slider moves picture, plan and charts together."""

import re

import pytest
from browser.served.recorded_clinic import RecordedClinic
from browser.sizes import fits, keep
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

PICTURE = "document.querySelector('.replay-frame iframe').contentWindow.__viserMutable?.nodePoseData"
MOMENT = f"(({PICTURE} ?? {{}})['/moment']?.position ?? [NaN])[0]"
CHAIR = f"(({PICTURE} ?? {{}})['/world/chair']?.position ?? [NaN])[0]"
ON_PLAN = "Number(/translate\\(([-\\d.e]+)/.exec(document.querySelector('.plan .chair').getAttribute('transform'))[1])"
CURSORS = """[...document.querySelectorAll(".cursor")].map(
  (one) => Math.round(Number(/translateX\\(([-\\d.]+)/.exec(one.style.transform)[1])))"""
TOUCHED = "main button, main select, main .segments label, main .pick, main .foot"


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    with RecordedClinic(tmp_path_factory.mktemp("clinic")) as app:
        yield app


@pytest.fixture(params=["1280x800", "768x1024"])
def page(request, served, open_page):
    """Return a page of one size, signed in."""
    page = open_page(served.link, request.param, color_scheme="dark")
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    page.keep = lambda name: keep(page, f"{request.param}-{name}")
    return page


def read(page, expression):
    return page.evaluate(f"() => {expression}")


def assert_at(page, until, t):
    """Assert that slider, plan, charts and the picture in 3D all show the moment `t`."""
    assert float(page.get_by_label("Moment of the trial").input_value()) == pytest.approx(t, abs=0.051)
    assert len(set(read(page, CURSORS))) == 1
    until(page, f"Math.abs({MOMENT} - {t}) < 0.06", seconds=60)
    assert read(page, CHAIR) == pytest.approx(read(page, ON_PLAN), abs=0.02)


def test_one_slider_moves_everything(page, until, served):
    page.goto(f"{served.address}/#/review/1/trial/{served.trials[0]}")
    slider = page.get_by_label("Moment of the trial")
    expect(page.locator(".time-chart")).to_have_count(6)
    until(page, f"Number.isFinite({MOMENT})", seconds=90)
    places = []
    for t in (3.0, 12.5, 5.0):
        slider.fill(str(t))
        assert_at(page, until, t)
        places.append((read(page, ON_PLAN), read(page, CURSORS)[0]))
    assert places[0] != places[1] != places[2]
    # A tap on a chart, then the keys.
    box = page.locator(".chart-box").first.bounding_box()
    page.locator(".chart-box").first.click(position={"x": box["width"] * 0.75, "y": 30})
    tapped = float(slider.input_value())
    assert tapped == pytest.approx(0.75 * 23, abs=2.0)
    slider.press("ArrowRight")
    assert float(slider.input_value()) == pytest.approx(tapped + 1.0, abs=0.06)
    page.get_by_role("heading", level=1).press("Shift+ArrowLeft")
    assert float(slider.input_value()) == pytest.approx(tapped - 9.0, abs=0.06)
    slider.press("Home")
    slider.press("p")
    expect(page.get_by_role("button", name="Pause")).to_be_visible()
    until(page, "Number(document.querySelector('.play-bar input[type=range]').value) > 0.5")
    slider.press("p")
    expect(page.get_by_role("button", name="Play")).to_be_visible()
    assert_at(page, until, float(slider.input_value()))
    # An event takes everything to its moment.
    stop = page.get_by_role("button", name=re.compile("Stop was pressed"))
    stop.click()
    assert float(slider.input_value()) == pytest.approx(14.5, abs=0.2)
    expect(page.locator(".over-picture")).to_be_hidden()
    page.keep("trial-replay")
    fits(page, TOUCHED)


def test_two_trials_are_chosen_and_compared(page, until, served):
    page.goto(f"{served.address}/#/review/1")
    for number in (1, 2):
        page.get_by_label(f"Compare trial {number}").check()
    page.get_by_role("link", name="Compare two trials").click()
    expect(page.get_by_role("heading", name="Two trials side by side")).to_be_visible()
    expect(page.locator(".plan .chair")).to_have_count(2)
    before = [one.get_attribute("transform") for one in page.locator(".plan .chair").all()]
    page.get_by_label("Moment of the trial").fill("6")
    after = [one.get_attribute("transform") for one in page.locator(".plan .chair").all()]
    assert all(a != b for a, b in zip(before, after, strict=True))
    expect(page.locator(".chart canvas")).to_have_count(2)
    expect(page.locator(".chart-legend li")).to_have_count(4)  # both trials in each
    expect(page.get_by_role("row", name=re.compile("Largest distance from the path"))).to_contain_text(
        re.compile(r"\d m")
    )
    page.keep("compare")
    fits(page, TOUCHED)
