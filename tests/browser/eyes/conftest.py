"""The clinic that the tests of this folder look at, and its owner's page."""

import pytest
from browser.eyes.axe import look_as
from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.places import put_back


@pytest.fixture(scope="module")
def eyes_clinic(tmp_path_factory):
    """Yield the clinic, which serves."""
    with EyesClinic(tmp_path_factory.mktemp("clinic")) as served:
        yield served


@pytest.fixture(scope="module")
def owners_page(browser, page_log, eyes_clinic):
    """Yield a page on which the owner is signed in; at the end it has asked no other machine."""
    log = page_log(eyes_clinic.address)
    page = log.watch(browser.new_context(storage_state=eyes_clinic.storage()).new_page())
    yield page
    page.context.close()
    assert [url for url in log.outside if not eyes_clinic.serves(url)] == []
    assert log.uncaught == []


@pytest.fixture
def clinic(eyes_clinic):
    """Yield the clinic as it always is; what a test has changed is put back."""
    yield eyes_clinic
    put_back(eyes_clinic)


@pytest.fixture
def page(owners_page):
    """Return the owner's page, in the light and as wide as a computer's."""
    look_as(owners_page, ("1280x800", "light"), settle=0)
    return owners_page
