"""A clinic with recorded trials, and pages of people who review them."""

import pytest
from browser.served.review_app import ReviewApp

from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.people import add_person, the_clinic


@pytest.fixture
def app(tmp_path):
    """Yield the clinic, which serves."""
    served = ReviewApp(tmp_path / "clinic")
    served.start()
    yield served
    served.stop()


@pytest.fixture
def open_for(browser, page_log, app):
    """Return what opens a page of the clinic for a person; at the end, no page has reported an error."""
    opened = []

    def open_page(name, role, where, size=(1280, 800)):
        with app.app.state.parts[Database].transaction() as db:
            token = sign_in(db, add_person(db, the_clinic(db), name, role, None), "test")
        context = browser.new_context(viewport={"width": size[0], "height": size[1]})
        context.add_cookies([{"name": "bodydrive_sign_in", "value": token, "url": app.address}])
        log = page_log(app.address)
        page = log.watch(context.new_page())
        opened.append((log, context))
        page.goto(f"{app.address}/#/{where}")
        page.get_by_role("button", name="Got it").click()  # the sentences of a first time
        return page

    yield open_page
    for log, context in opened:
        context.close()
        assert [error for error in log.errors if "404 (Not Found)" not in error] == log.outside == []
