"""From `make demo` to a scored trial by one source of movements: what a person does on a tablet, in a real browser."""

import os
import re
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from urllib.parse import urlsplit

from browser.conftest import FewPicturesBrowser, PageLog
from browser.driving import go_on_until, reaches_the_goal
from browser.fake_camera import browser_with_camera, own_browser
from browser.sizes import window
from browser.tablets import go_to, put_first_sentences_away
from playwright.sync_api import Error, expect
from processes.served_demo import printed_link, running_program
from sources_tried.far_ends import FAR_END_PORT, running
from sources_tried.figures import Course, Tried, likeness_of
from sources_tried.film import lean_angle
from sources_tried.person import FLOORPLAN, PATH
from sources_tried.processor import ProcessorTimes

from app.clock import monotonic
from folders import ROOT

SIZE = "768x1024"
STAND_INS = Path(__file__).with_name("stand_ins")
LOOK_EVERY = 250  # ms
OPENED_WITHIN = 30  # s: a device is opened for at most 8 s
JUDGED_AFTER = 3500  # ms: until then lamps may be those of the source before, and of what arrives nothing is said
LAMPS_WITHIN = 120  # s: software draws the camera's first picture in 20 s on an idle machine
IDLE = 3000  # ms: the next step of the calibration begins by itself after 1.5 s
CALIBRATED_WITHIN = 600  # s
METRE_WITHIN = 90  # s
MOST_REPEATS = 2  # of a step that has to be repeated
STILL_THERE = 2000  # ms, for a tap on what may have gone by itself
LEAST_PICTURES, SLOW_PICTURES = 20, 10  # a second that are read: with fewer, the camera is used with fewer frames
MOVES = ("Push", "Bend", "Move")  # words of a cue during a movement
PATIENT = "DEMO-2"  # of a demonstration: never calibrated


class Story:
    """A tablet, whose taps are counted; `stage` is what is tried now."""

    def __init__(self, page, link, name, photographs):
        self.page = page
        self.stage = "start"
        self.taps = 0
        self._base = link.partition("/#")[0]
        self._name, self._photographs = name, photographs
        page.goto(link)
        expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
        put_first_sentences_away(page)

    @property
    def card(self):
        """The card that says where the movements come from."""
        return self.page.locator("section.card[data-card=source]")

    @property
    def foot(self):
        """The foot of the page."""
        return self.page.locator(".foot")

    def tap(self, what):
        what.click()
        self.taps += 1

    def tap_if_there(self, what):
        """Tap what may go by itself at the same time."""
        with suppress(Error):
            what.click(timeout=STILL_THERE)
            self.taps += 1

    def tap_rail(self, page):
        """Go to a page by its step of the rail."""
        self.tap(self.page.locator(f'.rail a[href="#/{page}"]:visible'))

    def wait_until(self, is_so, seconds, what):
        """Wait until `is_so` returns true; AssertionError, which names `what` is missing, after so many seconds."""
        until = monotonic() + seconds
        while not is_so():
            assert monotonic() < until, f"{what} did not come within {seconds} s"
            self.page.wait_for_timeout(LOOK_EVERY)

    def get(self, path):
        """Ask the server as a page does."""
        return self.page.context.request.get(f"{self._base}/api/v1{path}").json()

    def photograph(self, moment):
        self.page.screenshot(path=self._photographs / f"{self._name}-{moment}.png")


def try_source(playwright, source, folder, photographs):
    """Try a source in a demonstration of its own, in an empty folder, and return what it came to."""
    tried, story = Tried(source.name), None
    with ExitStack() as ends:
        facts, ask = ends.enter_context(running(source.far_end, made(folder / "far-end")))
        browser = ends.enter_context(opened_browser(playwright, facts, made(folder / "browser")))
        began = monotonic()
        link, program = ends.enter_context(demonstration(made(folder / "demo"), facts))
        ask("watch", *link.split("/#demo="))
        page, log = ends.enter_context(opened_page(browser, link))
        try:
            story = Story(page, link, source.name, photographs)
            chooses(story, source, facts, ask)
            tried.lamps = good_lamps(story)
            begins_session(story, source)
            calibrates(story, source)
            tried.shares = drives(story, ask, program.pid)
            is_scored(story, f"{source.recorded}.")
            log.assert_quiet()
        except (AssertionError, Error) as error:
            tried.stopped = stop_words(story, error)
        if story is not None:
            tried.taps = story.taps
            take_report(tried, source.far_end, ask("report"), began, story.get("/equipment")["layout"])
    return tried


def made(folder):
    """Make a folder, and return it."""
    folder.mkdir(parents=True)
    return folder


@contextmanager
def demonstration(folder, facts):
    """Run a demonstration whose state lies in a folder; yield its link and its process.

    Where a far end needs them, the program finds stand-ins for the libraries of devices before the libraries.
    """
    environment = {"TMPDIR": str(folder)}
    if FAR_END_PORT in facts:
        environment |= {
            "PYTHONPATH": os.pathsep.join(map(str, (STAND_INS, ROOT, ROOT / "tests"))),
            FAR_END_PORT: facts[FAR_END_PORT],
        }
    with running_program("demo", "--port", "0", **environment) as process:
        yield printed_link(process), process


@contextmanager
def opened_browser(playwright, facts, folder):
    """Open the browser of the page; where the far end has a film, it stands before its camera."""
    film = facts.get("film")
    opened = browser_with_camera(playwright, Path(film), folder) if film else own_browser(playwright, folder)
    with opened as browser:
        yield browser


@contextmanager
def opened_page(browser, link):
    """Open a page for a demonstration; yield it, and the log of what it should not have done."""
    log = PageLog(urlsplit(link).netloc)
    context = FewPicturesBrowser(browser).new_context(viewport=window(SIZE), has_touch=True, permissions=["camera"])
    try:
        yield log.watch(context.new_page()), log
    finally:
        context.close()


def stop_words(story, error):
    """Return where and why a story went no further, and take a photograph of it."""
    why = next((line.strip() for line in str(error).splitlines() if line.strip()), type(error).__name__)
    if story is None:
        return f"start: {why}"
    story.photograph("stopped")
    return f"{story.stage}: {why}"


def chooses(story, source, facts, ask):
    """Choose a source, and wait until its lamps are green and the page says of nothing that it is wrong."""
    story.stage = "source"
    if source.is_short:
        starts_camera(story)
    else:
        story.tap_rail("shirt")
        opens_form(story, source.title)
        uses(story, {label: text.format(**facts) for label, text in source.fields.items()})
        for number in range(1, source.phones + 1):
            pairs_phone(story, number, ask)
        if source.places:
            opens_form(story)
            uses(story, source.places)

    def is_good():
        return good_lamps(story) >= source.lamps and not story.card.locator(".arrivals").count()

    story.page.wait_for_timeout(JUDGED_AFTER)
    story.wait_until(is_good, LAMPS_WITHIN, f"{source.lamps} green lamps")
    story.card.scroll_into_view_if_needed()
    story.photograph("source")


def good_lamps(story):
    """Return how many lamps are green."""
    return story.page.locator(".bodies .sensor[data-quality=good]").count()


def opens_form(story, title=""):
    """Open the form of the source; with the title of another one, choose that."""
    story.tap(story.card.locator("summary"))
    if title:
        story.tap(story.card.get_by_text(title, exact=True))


def uses(story, fields):
    """Fill in fields of the open form by their labels, and use the source."""
    card = story.card
    for label, value in fields.items():
        field = card.get_by_label(label, exact=True)
        match field.evaluate("(one) => one.type"):
            case "select-one":
                field.select_option(value)
                story.taps += 1
            case "file":
                field.set_input_files(value)
            case _:
                field.fill(value)
    story.tap(card.get_by_role("button", name="Use this"))

    def is_used():
        problem = " ".join(card.locator("form [role=alert]").all_inner_texts()).strip()
        assert not problem, problem
        return card.locator("details[open]").count() == 0

    story.wait_until(is_used, OPENED_WITHIN, "the source")


def pairs_phone(story, number, ask):
    """Pair the phone of this number, the next one, by the link of the page."""
    story.tap(story.card.get_by_role("button", name="Pair a phone"))
    ask("pair", story.card.locator(".paired pre code").inner_text())
    expect(story.card.locator(".paired-chair")).to_have_count(number)
    expect(story.card.locator(".paired")).to_have_count(0)


def starts_camera(story):
    """Take the camera of this device by the button of a demonstration; where it reads few pictures, ask for fewer."""
    story.tap(story.page.get_by_role("button", name="Move it yourself with this camera"))
    rate = story.page.locator("section.card[data-card=camera]").get_by_text(re.compile(r"^\d+ pictures? a second"))

    def pictures():
        shown = rate.all_inner_texts()
        return int(shown[0].split()[0]) if shown else 0

    story.wait_until(pictures, LAMPS_WITHIN, "a picture of the camera")
    count = pictures()
    if count < LEAST_PICTURES:
        opens_form(story)
        uses(story, {"Frames a second": "10" if count < SLOW_PICTURES else "15"})


def begins_session(story, source):
    """Start the session of somebody who was never calibrated, or go on with the open one, and go to the calibration."""
    story.stage = "session"
    page = story.page
    if not source.is_short:
        story.tap_rail("patients")
        story.tap(page.get_by_role("button", name="End session"))
        row = page.get_by_role("listitem").filter(has_text=PATIENT)
        story.tap(row.get_by_role("button", name="Start session"))
        expect(page.locator(".who")).to_contain_text(PATIENT)
        story.tap(page.get_by_role("link", name="Enter consent"))
        story.tap(page.get_by_role("button", name="Enter consent: Recording"))
        story.tap_rail("shirt")
    story.tap(story.foot.get_by_role("link", name="Calibrate"))


def calibrates(story, source):
    """Record each step of the calibration, use the result, and go on to driving; a short one does both by itself."""
    story.stage = "calibration"
    page, foot = story.page, story.foot
    result = page.get_by_role("heading", name="What this body can do")
    over = page.get_by_role("button", name="Start trial") if source.is_short else result
    repeats = {}
    is_photographed, idle = False, 0
    until = monotonic() + CALIBRATED_WITHIN
    story.tap(foot.get_by_role("button", name="Start", exact=True))
    while not over.is_visible():
        assert monotonic() < until, f"no result after {CALIBRATED_WITHIN} s"
        page.wait_for_timeout(LOOK_EVERY)
        calibration = story.get("/calibration")
        running = calibration["running"]
        name = running["step"] if running else calibration["current"]
        step = next(one for one in calibration["steps"] if one["id"] == name)
        if running or step["kind"] == "result":
            idle = 0
        if running:
            if not is_photographed and any(word in MOVES for word in page.locator(".cue-word").all_inner_texts()):
                is_photographed = True
                story.photograph("calibration")
        elif step["kind"] == "result":
            assert step["status"] != "failed", step["message"]
            poor = [one["message"] for one in calibration["steps"] if one["message"]]
            assert not (source.is_short and step["status"] == "done" and poor), poor
        elif idle < IDLE:
            idle += LOOK_EVERY
        else:
            idle = 0
            story.tap_if_there(foot.get_by_role("button", name=next_words(step, repeats), exact=True))
    if source.is_short:
        return
    story.tap(foot.get_by_role("button", name="Use this calibration"))
    expect(page.get_by_role("heading", name="Which movement does what")).to_be_visible()
    story.tap(foot.get_by_role("link", name="Drive with these"))


def next_words(step, repeats):
    """Return what is tapped where a step does not go on by itself; count in `repeats` how often it was repeated."""
    if step["status"] == "waiting":
        return "Start"
    count = repeats[step["id"]] = repeats.get(step["id"], 0) + 1
    if count <= MOST_REPEATS:
        return "Repeat this step"
    assert step["status"] == "done", step["message"]
    return "Next"


def drives(story, ask, program):
    """Drive the straight corridor to its goal; return the shares of a processor meanwhile (`ProcessorTimes`)."""
    story.stage = "drive"
    page = story.page
    go_to(page, f"drive/task/{FLOORPLAN}/{PATH}")
    start = page.get_by_role("button", name="Start trial")
    expect(start).to_be_visible()
    times = ProcessorTimes(program)
    story.tap(start)
    go_on_until(page, lambda: ask("look") is not None, "the first metre", seconds=METRE_WITHIN)
    story.photograph("drive")
    reaches_the_goal(page)
    return times.shares()


def is_scored(story, recorded):
    """Look at the result: it has figures, and says what moved the chair."""
    story.stage = "result"
    expect(story.page.get_by_text("Distance driven").first).to_be_visible()
    expect(story.page.locator("main")).to_contain_text(f"Source: {recorded}")
    story.photograph("result")


def take_report(tried, far_end, report, began, layout):
    """Add what the far end saw and sent, `began` (monotonic s) being the start of the demonstration."""
    metre_t, tried.ages, seen, sent = report
    if metre_t is not None:
        tried.seconds = metre_t - began
    t, levels = zip(*sent, strict=True)
    is_camera = far_end.shown == "trunk"
    known = Course(t, [lean_angle(level) for level in levels] if is_camera else levels)
    channels = layout["channels"] if layout else []
    fitting = [(at, values) for at, values in seen if len(values) == len(channels)]
    likenesses = [
        likeness_of(known, Course([at for at, _ in fitting], [values[i] for _, values in fitting]))
        for i, channel in enumerate(channels)
        if channel["joint"] == far_end.shown
    ]
    found = [likeness for likeness in likenesses if likeness is not None]
    if not found:
        return
    tried.likeness = max(found, key=lambda likeness: abs(likeness.correlation))
    if is_camera:
        tried.came_to = f"a lean is measured {abs(tried.likeness.slope):.2f} times as large as it is"
