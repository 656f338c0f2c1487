"""What many trials make of a page: verdicts on sessions and trials, a curve with its band, and what became worse."""

from collections.abc import Callable
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open, at, go, leave, open_all, opened, shows, steps
from browser.eyes.states.course_clinic import BETTER, WORSE, CourseClinic
from playwright.sync_api import expect

CHART = ".chart canvas"
NOISE = "Worse than this person's own noise"
GOOD_CHANGE = shows("main td.change.good")


def of_course(open_place: Callable[[Any, CourseClinic], object]) -> Open:
    """Return what opens a place in the clinic of people with a course of sessions."""

    def open_in_course(page: Any, clinic: EyesClinic) -> None:
        leave(page, clinic)
        course = clinic.other(page, CourseClinic)
        assert isinstance(course, CourseClinic)
        open_place(page, course)

    return open_in_course


def reviewed(page: Any, clinic: EyesClinic) -> None:
    """Show the verdicts on the newest session, all measures opened, above the learning curve with its band."""
    opened(f"review/{BETTER}")(page, clinic)
    expect(page.locator(CHART).first).to_be_attached()
    open_all(page)
    expect(page.locator(".session-verdicts td.change.good").first).to_be_visible()
    expect(page.locator(".session-verdicts")).to_contain_text("better than noise")


def deteriorated(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, f"review/{WORSE}")
    expect(page.locator(CHART).first).to_be_attached()
    expect(page.locator(".session-verdicts .problem")).to_contain_text(NOISE)


def attention_for_worse(page: Any, clinic: EyesClinic) -> None:
    go(page, clinic, "attention")
    expect(page.get_by_text("worked out")).to_have_count(0, timeout=60_000)
    expect(page.get_by_text(NOISE)).to_be_visible()


def compared_trials(page: Any, clinic: EyesClinic) -> None:
    steps(opened(f"review/{BETTER}/compare/{clinic.trials[6]}/{clinic.trials[-2]}"), GOOD_CHANGE)(page, clinic)


def compared_sessions(page: Any, clinic: CourseClinic) -> None:
    steps(opened(f"session/compare/{clinic.session(1)}/{clinic.session(4)}"), GOOD_CHANGE)(page, clinic)


def story(page: Any, clinic: CourseClinic) -> None:
    opened(f"session/story/{clinic.session(4)}")(page, clinic)


def measured_trial(page: Any, clinic: EyesClinic) -> None:
    steps(at(f"drive/over/{clinic.trials[-2]}"), shows(".large-figures .change"))(page, clinic)


def replaced(where: str, name: str) -> Open:
    """Return what opens a page with a replaced file on it, which can be put back."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        opened(where)(page, clinic)
        page.locator("summary", has_text="Replaced in the last 30 days").wait_for()
        open_all(page)
        button = page.get_by_role("button", name=f"Put back {name}")
        expect(button).to_be_visible()
        button.scroll_into_view_if_needed()

    return open_place


COURSE_PLACES: dict[str, Open] = {
    "review, verdicts": of_course(reviewed),
    "review, worse": of_course(deteriorated),
    "attention, worse": of_course(attention_for_worse),
    "review compare, verdicts": of_course(compared_trials),
    "session compare, verdicts": of_course(compared_sessions),
    "session story, course": of_course(story),
    "drive, over, verdicts": of_course(measured_trial),
    "shirt, replaced": of_course(replaced("shirt", "walk.csv")),
    "plans, replaced": of_course(replaced("plans", "ward-3")),
}
