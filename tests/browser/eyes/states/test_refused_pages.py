"""A page that a role may not see says so, and leads to one that it may."""

import pytest
from browser.eyes.places import PLACES, put_back

pytestmark = [pytest.mark.browser]


def test_every_page_of_an_owner_leads_a_clinician_to_another(page, clinic):
    for name in ("people", "log", "computer", "backup"):
        PLACES[f"{name}, clinician"](page, clinic)  # waits for the link
        assert page.get_by_role("button", name="Try again").count() == 0
        assert page.get_by_text("Only an owner").count() == 1
        put_back(clinic)
