"""What looks at the pages finds what it shall find: a test of the tests."""

import pytest
from browser.eyes.axe import findings
from browser.eyes.sweep import shown_ids

pytestmark = [pytest.mark.browser]

BROKEN = """<!doctype html><html lang="en"><title>A page</title><main><h1>A page</h1>
<p style="color:#999;background:#fff">Grey on white</p>
<p style="background:linear-gradient(#fff,#eee)">On a gradient</p>
<button style="width:44px;height:44px"></button>
<svg width="200" height="120"><rect width="200" height="120" fill="#eee"/>
<text id="faint" x="20" y="40" fill="#bbb">faint</text><text id="clear" x="20" y="80" fill="#222">clear</text></svg>
</main></html>"""


def test_what_is_wrong_is_found_and_what_is_right_is_not(browser):
    page = browser.new_page()
    page.set_content(BROKEN)
    found = {(one.kind, one.rule, one.target) for one in findings(page)}
    assert found == {
        ("violation", "color-contrast", "p:nth-child(2)"),
        ("undecided", "color-contrast", "p:nth-child(3)"),
        ("violation", "button-name", "button"),
        ("violation", "color-contrast", "#faint"),
    }
    page.context.close()


def test_an_id_that_is_shown_for_its_words_is_found(browser):
    page = browser.new_page()
    page.set_content(
        "<p>Left-hand <b>review-end-nothing</b></p><p>A lamp-shirt there</p><p aria-label='lamp-shirt'>x-y</p>"
    )
    assert shown_ids(page) == ["review-end-nothing", "lamp-shirt"]
    page.context.close()
