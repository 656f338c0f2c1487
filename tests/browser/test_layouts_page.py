"""A layout is made of what a simulated shirt sends, changed by keys, saved and used; the lamps then stand there."""

import json
from typing import Any

import pytest
from browser.sizes import each_size, fits, keep
from browser.tablets import go_to, put_first_sentences_away
from playwright.sync_api import expect

from app.layout import ShirtLayout

pytestmark = [pytest.mark.browser]

NAME = "Ward vest"
SENSOR = "collar"
REFUSED = "/api/v1/layouts/"  # a layout in use is not deleted, which the browser reports


def mark_of(page: Any) -> Any:
    """Return the mark of the chosen sensor on the body."""
    return page.locator(".place-mark[role=slider]")


def lamp_at(page: Any) -> tuple[float, float]:
    """Return where the lamp of the sensor is on the outline of the Shirt page."""
    place = page.get_by_role("radio", name=SENSOR).get_attribute("transform")
    x, y = place.removeprefix("translate(").removesuffix(")").split()
    return float(x), float(y)


def change_first_sensor(page: Any) -> None:
    """Give the first sensor a name, another side and another place by keys, then another one by a tap."""
    name = page.get_by_label("Name of the sensor")
    name.fill(SENSOR)
    name.press("Tab")
    mark = mark_of(page)
    expect(mark).to_have_attribute("aria-label", f"Place of {SENSOR}")
    page.get_by_role("radiogroup", name="Side of the body").get_by_text("Back").click()
    expect(mark).to_have_attribute("aria-valuetext", "Back: right shoulder")
    mark.focus()
    for _ in range(4):
        page.keyboard.press("Shift+ArrowDown")
    expect(mark).to_have_attribute("aria-valuetext", "Back: right upper arm")
    front = page.locator(".place-figures svg").first
    box = front.bounding_box()
    front.click(position={"x": box["width"] / 2, "y": box["height"] * 0.42})
    expect(mark).to_have_attribute("aria-valuetext", "Front: chest")
    for size in each_size(page):
        keep(page, f"{size}-layout-editor")
        fits(page, "main", size)


def export_and_import(page: Any, file: Any) -> None:
    """Export the layout in use, which cannot be deleted, as a file, and import that under another name."""
    page.get_by_role("link", name="All layouts").click()
    page.get_by_role("button", name=f"Delete “{NAME}”").click()
    expect(page.get_by_text("use another layout first")).to_be_visible()
    with page.expect_download() as download:
        page.get_by_role("button", name=f"Export “{NAME}”").click()
    download.value.save_as(file)
    layout = ShirtLayout.model_validate(json.loads(file.read_text()))
    assert (layout.name, layout.channels[0].name, len(layout.channels)) == (NAME, SENSOR, 52)

    # What is no layout is refused in one sentence.
    page.get_by_text("A file with a layout", exact=True).click()
    no_layout = {"name": "x.json", "mimeType": "application/json", "buffer": b"[1]"}
    page.get_by_label("File", exact=True).set_input_files(no_layout)
    page.get_by_role("button", name="Make the layout").click()
    expect(page.get_by_role("alert").filter(has_text="x.json: this is no layout")).to_be_visible()
    page.get_by_label("File", exact=True).set_input_files(file)
    page.get_by_label("Name of the layout").fill("Again")
    page.get_by_role("button", name="Make the layout").click()
    expect(page.get_by_role("heading", name="Layout: Again")).to_be_visible()


def test_a_layout_is_made_changed_saved_and_used(own_demo: str, open_page: Any, tmp_path: Any) -> None:
    page = open_page(own_demo, allowed=REFUSED)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    put_first_sentences_away(page)
    go_to(page, "shirt")
    page.get_by_role("link", name="All layouts").click()
    expect(page.get_by_role("heading", name="Layouts", exact=True)).to_be_focused()
    page.get_by_label("Name of the layout").fill(NAME)
    page.get_by_role("button", name="Make the layout").click()
    expect(page.get_by_role("heading", name=f"Layout: {NAME}")).to_be_visible()

    change_first_sensor(page)
    page.get_by_role("button", name="Save", exact=True).click()
    expect(page.get_by_text(f"“{NAME}” was saved.")).to_be_visible()
    page.get_by_role("button", name="Use", exact=True).click()
    expect(page.get_by_text(f"The shirt now has the layout “{NAME}”.")).to_be_visible()

    # The lamp of the sensor stands where it was put, and is lit.
    go_to(page, "shirt")
    expect(page.locator("[data-card=layout]")).to_contain_text(f"{NAME}, 52 sensors")
    lamp = page.get_by_role("radio", name=SENSOR)
    expect(lamp).to_have_attribute("data-quality", "good")
    x, y = lamp_at(page)
    assert 90 < x < 110
    assert 85 < y < 110
    export_and_import(page, tmp_path / "vest.json")
