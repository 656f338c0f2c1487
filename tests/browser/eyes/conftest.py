"""The clinic that the tests of this folder look at, and its owner's page."""

import pytest
from browser.eyes.eyes_clinic import EyesClinic
from playwright.sync_api import expect

PATIENCE = 60_000  # ms: a busy machine is slow


@pytest.fixture(autouse=True, scope="module")
def patience():
    """Let every expectation wait for as long as a busy machine may take."""
    expect.set_options(timeout=PATIENCE)
    yield
    expect.set_options(timeout=5000)


@pytest.fixture(scope="module")
def clinic(tmp_path_factory):
    """Yield the clinic, which serves."""
    served = EyesClinic(tmp_path_factory.mktemp("clinic"))
    served.start()
    yield served
    served.stop()


@pytest.fixture(scope="module")
def page(browser, page_log, clinic):
    """Yield a page on which the owner is signed in; at the end it has asked no other machine."""
    log = page_log(clinic.address)
    page = log.watch(browser.new_context(storage_state=clinic.storage()).new_page())
    page.set_default_timeout(PATIENCE)
    yield page
    page.context.close()
    assert log.outside == []
    assert [error for error in log.errors if error.startswith("uncaught")] == []
