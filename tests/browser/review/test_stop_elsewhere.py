"""A reviewer who looks on from elsewhere has no Stop of the clinic; whoever is in the building has."""

import pytest
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser]

THROUGH_A_PROXY = {"Via": "1.1 proxy"}


@pytest.mark.parametrize(
    ("role", "headers", "has_stop"),
    [
        ("reviewer", {}, True),
        ("reviewer", THROUGH_A_PROXY, False),
        ("clinician", THROUGH_A_PROXY, True),
    ],
)
def test_who_has_a_stop(open_for, role, headers, has_stop):
    page = open_for("Rhea", role, "review/1")
    stops = []
    page.on("request", lambda request: stops.append(request.url) if request.url.endswith("/control/stop") else None)
    page.context.set_extra_http_headers(headers)
    page.reload()
    expect(page.get_by_role("heading", name="What was learnt")).to_be_visible()
    expect(page.locator("header .stop")).to_be_visible(visible=has_stop)
    assert stops == []
