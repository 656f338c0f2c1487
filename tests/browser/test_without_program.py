"""Pages that lose the program show nothing as present and offer only Stop; a page takes no other page's word."""

import os
import re
import signal
from contextlib import ExitStack

import pytest
from browser.driving import drives_until, go_on_until, speed_in
from browser.sizes import each_size, keep, window
from browser.tablets import put_first_sentences_away
from playwright.sync_api import expect
from processes.served_demo import bodydrive, printed_link

pytestmark = [pytest.mark.browser]

SINCE = re.compile(r"No connection to the program since \d\d:\d\d:\d\d\.")
WAITS = re.compile(r"The trial waits for Continue\. Without it, the trial ends in [34]:\d\d")
OFFERED = """() => [...document.querySelectorAll(".btn, button, a, input, [tabindex]")]
  .filter((one) => one.checkVisibility({ checkVisibilityCSS: true }) && !one.closest("[inert]") && !one.disabled)
  .filter((one) => one.tabIndex >= 0)
  .map((one) => one.getAttribute("aria-label") || one.innerText)"""

WORD_OF = "() => sessionStorage.getItem('bodydrive-screen')"


@pytest.fixture
def pages(browser, page_log):
    """Yield a running demonstration, a page with a trial that is halted, one with the shirt; both signed in."""
    with ExitStack() as stack:
        process = stack.enter_context(bodydrive("demo", "--port", "0"))
        stack.callback(end, process)
        link = printed_link(process)
        log = page_log(link)
        context = browser.new_context(viewport=window("1280x800"))
        stack.callback(context.close)
        driven, shirt = (log.watch(context.new_page()) for _ in range(2))
        driven.goto(link)
        expect(driven.get_by_role("heading", name="Where to?")).to_be_visible()
        put_first_sentences_away(driven)
        driven.get_by_role("button", name="Start trial").click()
        drives_until(driven, 1)
        driven.locator("#stop").dispatch_event("pointerdown")
        expect(driven.locator(".fault-card")).to_contain_text(WAITS)
        shirt.goto(f"{link.split('#')[0]}#/shirt")
        expect(shirt.locator(".bodies .sensor")).to_have_count(52)
        expect(shirt.locator(".lamps")).to_contain_text("Shirt 52 of 52")
        yield process, driven, shirt
        assert log.outside == []


def end(process):
    if process.poll() is None:
        process.send_signal(signal.SIGCONT)
        process.send_signal(signal.SIGINT)
    process.wait(30)


def shows_nothing_as_present(page, picture):
    expect(page.locator(".notes")).to_contain_text(SINCE)
    expect(page.locator(".notes")).to_contain_text("stops by itself")
    expect(page.locator(".lamps")).to_have_text("Shirt: not knownChair: not known")
    assert [words for words in page.evaluate(OFFERED) if "Colours" not in words] == ["Stop the chair now"]
    assert float(page.locator("main").evaluate("(main) => getComputedStyle(main).opacity")) < 0.5
    keep(page, f"without-program-{picture}")


def test_pages_that_lose_their_word_or_the_chair_or_the_program(pages):
    process, driven, shirt = pages
    a_page_with_the_word_of_another_is_refused_and_takes_one_of_its_own(driven, shirt)
    a_page_that_does_not_hear_the_chair_does_not_keep_it_driving(driven, shirt)
    without_the_program_no_page_shows_a_present_or_offers_what_needs_it(process, driven, shirt)


def a_page_with_the_word_of_another_is_refused_and_takes_one_of_its_own(driven, other):
    word = driven.evaluate(WORD_OF)
    assert other.evaluate(WORD_OF) != word
    other.evaluate("(word) => sessionStorage.setItem('bodydrive-screen', word)", word)
    other.reload()
    assert other.evaluate(WORD_OF) == word  # it was loaded again, and believes to be that screen
    while other.evaluate(WORD_OF) == word:
        other.wait_for_timeout(100)
    assert driven.evaluate(WORD_OF) == word
    driven.bring_to_front()
    go_on_until(driven, lambda: driven.locator(".fault-card").count() == 0, "the end of the halt")


def a_page_that_does_not_hear_the_chair_does_not_keep_it_driving(driven, other):
    """Only the live socket is cut; the worker's would go on. Either of two signs may stop the chair first."""
    passed = []

    def pass_on(route):
        passed.append(route)
        if is_cut:
            route.close()
        else:
            route.connect_to_server()

    is_cut = False
    driven.route_web_socket(re.compile("/api/v1/live$"), pass_on)
    driven.reload()
    driven.bring_to_front()
    speed = driven.locator(".bar .speed .big")
    go_on_until(driven, lambda: speed_in(speed.inner_text()) >= 0.1, "a speed")
    is_cut = True
    passed[-1].close()
    expect(driven.locator(".notes")).to_contain_text(SINCE)
    expect(other.locator(".lamps")).to_contain_text("Chair: virtual")  # no longer armed
    is_cut = False
    expect(driven.locator(".notes")).to_be_empty()
    driven.locator("#stop").dispatch_event("pointerdown")


def without_the_program_no_page_shows_a_present_or_offers_what_needs_it(process, driven, shirt):
    go_on = driven.get_by_role("button", name="Continue")
    expect(go_on).to_be_visible()
    os.kill(process.pid, signal.SIGSTOP)
    shows_nothing_as_present(shirt, "shirt")
    shows_nothing_as_present(driven, "drive")
    expect(go_on).to_be_hidden()

    os.kill(process.pid, signal.SIGCONT)
    expect(driven.locator(".notes")).to_be_empty()
    expect(driven.locator(".lamps")).to_contain_text("Shirt 52 of 52")
    expect(go_on).to_be_visible()
    expect(driven.locator(".fault-card")).to_contain_text(WAITS)

    end(process)
    shows_nothing_as_present(driven, "drive-down")
    for size in each_size(driven, ("768x1024", "390x844"), settle=0):
        keep(driven, f"without-program-{size}")
    driven.locator("#stop").dispatch_event("pointerdown")
    expect(driven.get_by_text("Stop did not get through")).to_be_visible()
