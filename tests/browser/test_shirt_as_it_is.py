"""The Shirt page's sentence, the ticks of the steps and "Start trial" follow the shirt as it is now, without reload."""

from contextlib import closing

import pytest
from api.fake_process import LAYOUT
from browser.served.clinic_app import go
from browser.sizes import keep, window
from browser.tablets import choose_network_shirt
from browser.wave_sender import WaveSender
from playwright.sync_api import expect
from processes.udp_shirt import free_port

from app.layout import ShirtLayout

pytestmark = [pytest.mark.browser]

OTHER_NUMBER = "the shirt sends 40 sensors, its layout has 52"
NO_FRAMES = "No frames from a shirt on 127.0.0.1:5252."
OTHER_LAYOUT = ShirtLayout(name="Another shirt", channels=LAYOUT.channels[:6], joints=LAYOUT.joints[:3])
READY = ("Patients", "Shirt", "Calibrate", "Controls")
PAGES = ("shirt", "drive", "controls", "calibrate")  # that are open when the shirt changes


@pytest.fixture
def page(browser, page_log, served):
    log = page_log(served.address)
    served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
    yield served.sign_in(log.watch(browser.new_page(viewport=window("768x1024"))), "A-03")
    log.assert_quiet()


def expect_ticks(page, steps):
    """Wait until these steps have a tick, and no other."""
    ticked = page.locator(".rail a:has(.done:not([hidden]))")
    expect(ticked).to_have_text([f"{step}done" for step in steps])


def expect_all(page, where, steps, sentence, obstacle=None):
    """Wait until the rail, and the page `where`, which is open, say what is true of the shirt.

    `obstacle` is why no trial is started, and the button that leads on; None: a trial can be started.
    """
    expect_ticks(page, steps)
    if where == "shirt":
        expect(page.locator(".lead")).to_contain_text(sentence)
        onward = {None: ["Go on to drive"], "Calibrate": ["Calibrate"], "To the shirt": []}
        expect(page.locator(".foot .go:visible")).to_have_text(onward[obstacle and obstacle[1]])
    if where == "controls":
        expect(page.locator(".foot .go")).to_have_text(obstacle[1] if obstacle else "Drive with these")
        expect(page.locator("main")).to_contain_text(obstacle[0] if obstacle else "")
    if where == "drive":
        foot, start = page.locator(".foot"), page.get_by_role("button", name="Start trial")
        if obstacle is None:
            expect(start).to_be_visible()
            return
        expect(start).to_have_count(0)
        expect(foot).to_contain_text(obstacle[0])
        expect(foot.get_by_role("link", name=obstacle[1])).to_be_visible()


def test_all_follow_a_shirt_that_falls_silent_and_sends_again(page, served):
    process = served.process
    for where in PAGES:
        go(page, where)
        for _ in range(2):
            process.sends, process.shirt_words = True, "Sends."
            expect_all(page, where, READY, "Sends.")
            process.sends, process.shirt_words = False, NO_FRAMES
            expect_all(page, where, ("Patients",), NO_FRAMES, ("The shirt sends no signals", "To the shirt"))
        keep(page, f"768x1024-silent-{where}")
        process.sends, process.shirt_words = True, "Sends."


def test_what_changes_while_a_page_reads_is_not_lost(page, served):
    process = served.process
    process.sends, process.shirt_words = False, NO_FRAMES
    go(page, "settings")
    expect_ticks(page, ("Patients",))

    def answer_late(route):
        answer = route.fetch()  # of the silent shirt; it comes to the page after the news that the shirt sends
        process.sends, process.shirt_words = True, "Sends."
        expect_ticks(page, READY)
        route.fulfill(response=answer)

    page.route("**/api/v1/controls", answer_late, times=1)
    page.get_by_role("link", name="Controls").click()
    expect_all(page, "controls", READY, "Sends.")


def test_all_follow_another_shirt_that_is_chosen_on_another_screen(page, served):
    process = served.process
    for where in PAGES:
        go(page, where)
        expect_all(page, where, READY, "Sends.")
        process.layout, process.shirt_words = OTHER_LAYOUT, "Another shirt sends."
        served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 2})
        obstacle = ("The patient was calibrated in another shirt", "Calibrate")
        expect_all(page, where, ("Patients", "Shirt"), "Another shirt sends.", obstacle)
        process.layout, process.shirt_words = LAYOUT, "Sends."
        served.good("PUT", "/equipment/shirt", {"kind": "simulator", "seed": 1})
        expect_all(page, where, READY, "Sends.")


def test_frames_of_another_number_of_sensors_are_no_signals(own_demo, open_page):
    page, port = open_page(own_demo), free_port()
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    choose_network_shirt(page, port).get_by_role("button", name="Use this").click()
    lead, obstacle = page.locator(".lead"), page.locator(".foot").get_by_text("The shirt sends no signals")
    expect(lead).to_contain_text(f"No frames from a shirt on 127.0.0.1:{port}.")
    with closing(WaveSender(port)) as sender:
        for channels, words in ((52, "52 sensors"), (40, OTHER_NUMBER), (52, "52 sensors")):
            is_shirt = channels == 52
            go(page, "shirt")
            sender.channels = channels
            expect(lead).to_contain_text(words)
            expect_ticks(page, ("Patients", "Shirt") if is_shirt else ("Patients",))
            go(page, "drive")
            expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
            expect(obstacle).to_have_count(0 if is_shirt else 1)
            sender.channels = 40 if is_shirt else 52
            expect(obstacle).to_have_count(1 if is_shirt else 0)


def test_what_is_open_and_typed_stays_when_another_screen_changes_the_equipment(page, served):
    go(page, "shirt")
    source, head = page.locator("[data-card=source]"), page.locator("[data-card=head]")
    source.locator("summary").click()
    source.get_by_text("A shirt over the network", exact=True).click()
    port = source.get_by_label("Port")
    port.fill("5999")
    field = port.element_handle()
    for config, words in (
        ({"kind": "simulator", "seed": 1}, "Simulated head."),
        (None, "None: the view looks straight ahead."),
    ):
        served.good("PUT", "/equipment/head", {"config": config})
        expect(head).to_contain_text(words)
        expect(port).to_be_focused()
        expect(port).to_have_value("5999")
        assert field.evaluate("(input) => input.isConnected")
