"""A recording of another program: the page says what it holds, a person confirms it, and the shirt plays it."""

import math

import pytest
from browser.sizes import fits
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

ROWS = [f"{20 * i};{500 + 90 * math.sin(i / 9):.2f};{math.cos(i / 7):.3f}".replace(".", ",") for i in range(600)]
RECORDING = {
    "name": "Arm links.csv",
    "mimeType": "text/csv",
    "buffer": "\n".join(["Rekorder 7", "Zeit (ms);Winkel Ellbogen links [mV];Rauschen", *ROWS, ""]).encode(),
}


def test_a_table_with_decimal_commas_and_milliseconds_becomes_the_shirt(demo, open_page):
    page = open_page(demo)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    page.goto(f"{demo.split('#')[0]}#/shirt")
    source = page.locator("[data-card=source]")
    source.get_by_text("Change", exact=True).click()
    source.get_by_text("Replay of a file", exact=True).click()
    source.get_by_role("link", name="Import a recording").click()
    expect(page.get_by_role("heading", name="Import a recording")).to_be_visible()
    page.locator("main input[type=file]").set_input_files(RECORDING)
    facts = page.locator(".fact-list")
    expect(facts).to_contain_text("50 Hz")
    expect(facts).to_contain_text("semicolons between columns and decimal commas")
    expect(facts).to_contain_text("600 samples")
    expect(page.get_by_label("Unit of the times")).to_have_value("ms")
    expect(page.get_by_text("in milliseconds.")).to_be_visible()
    page.get_by_text("2 of 2 columns are channels").click()
    expect(page.get_by_label("Joint of Winkel Ellbogen links [mV]")).to_have_value("left_elbow")
    page.get_by_label("Joint of Rauschen").select_option("left_wrist")
    fits(page, "main")
    page.get_by_role("switch", name="Rauschen").click(force=True)
    expect(page.get_by_text("1 of 2 columns are channels")).to_be_visible()
    expect(page.get_by_role("status").filter(has_text="being read")).to_have_count(0)
    page.get_by_role("button", name="Use it", exact=True).click()
    expect(page.get_by_role("heading", name="The shirt")).to_be_visible()
    expect(page.get_by_text("Arm-links.parquet").first).to_be_visible()
    lamp = page.locator(".bodies .sensor")
    expect(lamp).to_have_count(1)
    lamp.first.click(force=True)
    now = page.locator(".sensor-card .number").first
    before = now.inner_text()
    expect(now).not_to_have_text(before)  # the lamp's signal moves
