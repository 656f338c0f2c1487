"""The clinic that the tests of this folder look at, and its owner's page."""

import pytest
from browser.eyes.eyes_clinic import EyesClinic


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
    yield page
    page.context.close()
    assert [url for url in log.outside if not clinic.serves(url)] == []
    assert [error for error in log.errors if error.startswith("uncaught")] == []
