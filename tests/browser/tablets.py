"""Tablets of two sizes, signed in to a demonstration, and what a page sends with a change."""

from contextlib import contextmanager

from playwright.sync_api import expect

from folders import SCREENSHOTS

TABLETS = {"1024x768": (1024, 768), "820x1180": (820, 1180)}


@contextmanager
def signed_in(name, browser, page_log, link, **options):
    """Yield a page of one tablet, signed in to the demonstration, and a function that keeps a screenshot.

    The `options` are those of `new_context`.
    """
    width, height = TABLETS[name]
    page = browser.new_page(viewport={"width": width, "height": height}, has_touch=True, **options)
    log = page_log(link)
    log.watch(page)
    SCREENSHOTS.mkdir(parents=True, exist_ok=True)
    page.goto(link)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    put_first_sentences_away(page)
    yield page, lambda picture: page.screenshot(path=SCREENSHOTS / f"{name}-{picture}.png")
    log.assert_clean()
    page.close()


def put_first_sentences_away(page):
    """Put the sentences for a first time away, where nobody has done it in this clinic before."""
    if not page.context.request.get(page.url.split("#")[0] + "api/v1/auth/me").json()["introduced"]:
        page.get_by_role("button", name="Got it").click()
        expect(page.locator(".first-sentences")).to_have_count(0)


def go_to(page, step):
    page.goto(page.url.split("#")[0] + f"#/{step}")


def headers_of(calls, base):
    """Return what a page of ours sends with a change: its origin, and the session that it shows."""
    session = calls.get(f"{base}/api/v1/session").json()["session"]
    return {"Origin": base, "Patient-Session": str(session["id"])}
