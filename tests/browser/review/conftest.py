"""Pages of people who review the trials of a clinic."""

import pytest


@pytest.fixture
def app(recorded):
    """Return the clinic, which serves."""
    return recorded


@pytest.fixture
def open_for(app, open_page):
    """Return what opens a page of the clinic for a person, who is added to it."""

    def open_place(name, role, where, size="1280x800"):
        token = app.sign_in_as(name, role)
        page = open_page(f"{app.address}/#/{where}", size, sign_in=token, allowed="404 (Not Found)")
        page.get_by_role("button", name="Got it").click()  # the sentences of a first time
        return page

    return open_place
