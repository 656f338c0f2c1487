"""`python tests/browser/touched.py`: prints the files of browser tests that `make test` runs for what has changed.

Changed is what differs from the branch `main`, committed or not. The rule:

- always: the story of a clinic, a calibration, and the notices of a stop;
- a page (`web_static/js/pages/NAME/`): the sweep of all pages, and each file of tests whose text or name has NAME;
- a file of browser tests: itself;
- anything else in `web_static/` or in `tests/browser/`, which many pages or tests share: all browser tests.

A change in `app/` adds none: the tests of `app/` are there for it. `.ci/run` runs all browser tests.
"""

import re
import subprocess
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = "tests/browser/"
ALWAYS = tuple(FOLDER + one for one in ("test_story.py", "test_calibrate_page.py", "eyes/states/test_stop_strip.py"))
SWEEP = f"{FOLDER}eyes/test_axe.py"
PAGE = re.compile(r"web_static/js/pages/(\w+)/")
BRANCHES = ("main", "origin/main")


def files_of_tests() -> dict[str, str]:
    """Return the text of each file of browser tests, by its path from the root."""
    return {file.relative_to(ROOT).as_posix(): file.read_text() for file in (ROOT / FOLDER).rglob("test_*.py")}


def opens(page: str, file: str, text: str) -> bool:
    """Return whether a file of tests is about a page: by its own name, or by an address or a place in its text."""
    return f"/test_{page}_" in file or re.search(rf'["/]{page}["/,?]', text) is not None


def touched(changed: Iterable[str], tests: Mapping[str, str]) -> list[str]:
    """Return the files of browser tests to run.

    Parameters
    ----------
    changed : paths from the root
    tests : the text of each file of browser tests, by its path from the root
    """
    chosen = set(ALWAYS)
    for file in changed:
        page = PAGE.match(file)
        if file in tests:
            chosen.add(file)
        elif page:
            chosen |= {SWEEP} | {test for test, text in tests.items() if opens(page[1], test, text)}
        elif file.startswith(("web_static/", FOLDER)):
            return [FOLDER]
    return sorted(chosen)


def changed_files() -> list[str]:
    """Return the paths that differ from the branch `main`; none where there is no git, as in an unpacked archive."""
    for branch in BRANCHES:
        base = _git("merge-base", branch, "HEAD")
        if base:
            return _git("diff", "--name-only", base[0]) + _git("ls-files", "--others", "--exclude-standard")
    return []


def _git(*words: str) -> list[str]:
    try:
        answer = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return []
    return answer.stdout.splitlines() if answer.returncode == 0 else []


if __name__ == "__main__":
    sys.stdout.write(" ".join(touched(changed_files(), files_of_tests())) + "\n")
