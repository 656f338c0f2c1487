"""A file whose name is taken: the page asks, keeps both, replaces, and puts back; Stop stays in reach meanwhile."""

import pytest
from browser.sizes import SIZES, fits, keep
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

TAKEN = "409 (Conflict)"  # what a browser writes by itself when a name is taken


@pytest.mark.parametrize("size", SIZES)
def test_a_taken_name_is_asked_about(demo, open_page, size):
    page = open_page(demo, size, allowed=TAKEN, has_touch=True)
    name = f"walk-{size}.csv"

    def bring(number):
        rows = "".join(f"{i / 100},{number}\n" for i in range(20))
        file = {"name": name, "mimeType": "text/csv", "buffer": f"t,a\n{rows}".encode()}
        page.locator("input[type=file][accept='.csv,.parquet']").first.set_input_files(file)

    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    page.goto(f"{demo.split('#')[0]}#/shirt")
    source = page.locator("section.card[data-card=source]")
    source.locator("summary").first.click()
    source.get_by_text("Replay of a file").click()
    bring(1)
    expect(page.get_by_text(f"{name} was added.")).to_be_visible()
    bring(2)
    question = page.get_by_role("alertdialog").filter(has_text=f"There is '{name}' already")
    expect(question).to_be_visible()
    fits(page, "[role=alertdialog]")
    keep(page, f"{size}-same-name")
    page.keyboard.press("Escape")
    expect(question).to_be_hidden()
    bring(2)
    question.get_by_role("button", name="Replace it").click()
    expect(page.get_by_text(f"{name} was added.")).to_be_visible()
    page.get_by_text("Replaced in the last 30 days").click()
    page.get_by_role("button", name=f"Put back {name}").scroll_into_view_if_needed()
    keep(page, f"{size}-replaced")
    page.get_by_role("button", name=f"Put back {name}").click()
    expect(page.get_by_text(f"{name.removesuffix('.csv')}-2.csv is back.")).to_be_visible()
