"""Which browser tests `make test` runs for a change: always a few, of a changed page its own, of shared parts all."""

import pytest
from browser.touched import ALWAYS, FOLDER, ROOT, SWEEP, files_of_tests, touched

PAGES = sorted(folder.name for folder in (ROOT / "web_static" / "js" / "pages").iterdir() if folder.is_dir())
TESTS = files_of_tests()


def page_file(page):
    return f"web_static/js/pages/{page}/{page}.js"


@pytest.mark.parametrize("changed", [[], ["app/store/people.py", "docs/README.md", "tests/store/test_people.py"]])
def test_without_a_changed_page_the_story_a_calibration_and_a_stop_are_run(changed):
    assert touched(changed, TESTS) == sorted(ALWAYS)
    assert set(ALWAYS) | {SWEEP} <= TESTS.keys()


def test_a_changed_page_brings_the_sweep_and_the_tests_that_open_it():
    chosen = set(touched([page_file("shirt")], TESTS))
    assert chosen >= {*ALWAYS, SWEEP, f"{FOLDER}test_shirt_sender.py", f"{FOLDER}test_shirt_as_it_is.py"}
    assert f"{FOLDER}review/test_comments.py" not in chosen
    assert f"{FOLDER}host/test_backup_page.py" in touched([page_file("backup")], TESTS)


def test_each_page_has_a_test_of_its_own_beside_the_sweep():
    always = {*ALWAYS, SWEEP}
    assert [page for page in PAGES if not set(touched([page_file(page)], TESTS)) - always] == []


def test_a_changed_test_is_run():
    changed = f"{FOLDER}review/test_comments.py"
    assert touched([changed], TESTS) == sorted({*ALWAYS, changed})


@pytest.mark.parametrize("shared", ["web_static/js/shell/rail.js", "web_static/css/base.css", f"{FOLDER}conftest.py"])
def test_what_pages_or_tests_share_brings_all(shared):
    assert touched([page_file("shirt"), shared], TESTS) == [FOLDER]
