"""`python -m features.without_feature FOLDER`: run the program as it is, then without some of its features.

Without a feature: as if its folder and its line were gone. Writes `whole.json`, and a file for each set of features in
HIDDEN, with the status of each answer: of every page, and of every route that reads, asked about a patient who was
calibrated and has driven a trial; then of the end of the session and the erasure of the patient.

All but the features is imported once, while no feature can be found: nothing outside of them needs one to be imported.
So are the pages, places and words read, which are the same in each run. Each run is a fork of the process that imported
it, so that it imports its features itself.
"""

import gc
import json
import os
import re
import sys
import traceback
from collections.abc import Iterable, Iterator
from importlib import import_module
from importlib.abc import MetaPathFinder
from pathlib import Path
from typing import Any

from fastapi import FastAPI
from fastapi.routing import APIRoute

from app import features

# What the features, and the program, import late, of others.
LATE = ("anyio._backends._asyncio", "attr", "matplotlib.figure", "pyarrow.parquet", "scipy.signal", "tarfile")
WHOLE = "whole"
HIDDEN = (
    ("records", "sharing", "reports", "consents", "interface_tests"),
    ("records", "comments", "archive"),
    ("sharing", "exports", "backup", "prior"),
    ("reports", "exports", "log", "lsl"),
    ("consents", "comments", "backup", "lsl", "layouts"),
    ("interface_tests", "archive", "log", "prior", "layouts"),
)
"""The features that are hidden in each run. Each stands in two runs, and no two features in the same two: so each is
hidden while each other one that does not need it is there, in about half as many runs as there are features."""


class WithoutFolders(MetaPathFinder):
    """Finds no module of these features."""

    def __init__(self, names: Iterable[str]) -> None:
        self._folders = tuple(f"app.features.{name}" for name in names)

    def find_spec(self, name, path=None, target=None):  # noqa: ARG002  (as importlib calls it)
        if any(name == folder or name.startswith(f"{folder}.") for folder in self._folders):
            raise ModuleNotFoundError(f"No module named '{name}'", name=name)


def hide(*names: str) -> None:
    """Take features out of the program: their lines, and their folders."""
    features.NEEDS = {each: needs for each, needs in features.NEEDS.items() if each not in names}  # type: ignore[misc]
    sys.meta_path.insert(0, WithoutFolders(names))


def import_all_but_features() -> None:
    """Import the program, its web application, and what the tests of this import, while no feature can be found.

    Read what a program reads once, whatever features it has.
    """
    without = WithoutFolders(features.NEEDS)
    sys.meta_path.insert(0, without)
    for name in (*LATE, "api.conftest", "app.cli.main"):
        import_module(name)
    from app.api.app import _pages
    from app.texts import LANGUAGES, load_language
    from app.world.scene import bundled_places

    _pages()
    bundled_places()
    for language in LANGUAGES:
        load_language(language)
    sys.meta_path.remove(without)


GIVEN = {
    "floorplan": "apartment",
    "path": "main",
    "other": "1",
    "form": "csv",
    "role": "clinician",
    "consent": "sharing",
}
ENDLESS = {"/api/v1/live"}


def requests(app: FastAPI) -> Iterator[tuple[str, dict[str, str]]]:
    """Yield every path that reads, with the names in it and the query that it needs filled."""
    from api.served_routes import contexts, needed_query

    for context in contexts(app, APIRoute):
        path = context.path
        query = {name: GIVEN.get(name, "1") for name in needed_query(context.dependant)}
        if path.endswith("/report"):
            query["form"] = "html"
        if "GET" in context.methods and context.original_route.include_in_schema and path not in ENDLESS:
            yield re.sub(r"\{(\w+)\}", lambda name: GIVEN.get(name[1], "1"), path), query


def answers(folder: Path) -> dict[str, int]:
    """Return the status of each answer."""
    import pytest
    from api.conftest import new_demonstration, quick, sign_in
    from api.running_app import running

    from app.clock import utc_now
    from app.settings import static_folder

    found: dict[str, int] = {}
    settings = new_demonstration(folder / "state")
    with pytest.MonkeyPatch.context() as monkeypatch:
        quick(monkeypatch)
        for clinic in running(settings):
            sign_in(clinic)
            app: Any = clinic.client.app
            patient = clinic.begin_session()
            clinic.calibrate()
            clinic.drive_trial()
            today = utc_now().astimezone().date().isoformat()
            clinic("PUT", f"/patients/{patient['id']}/consents/sharing", json={"given": today})
            for page in sorted(static_folder().glob("*.html")):
                found[f"GET /{page.name}"] = clinic.client.get(f"/{page.name}").status_code
            for path, query in requests(app):
                found[f"GET {path}"] = clinic("GET", path.removeprefix("/api/v1"), params=query).status_code
            for method, path in (
                ("DELETE", "/session"),
                ("DELETE", f"/patients/{patient['id']}"),
                ("POST", f"/deleted-patients/{patient['id']}/erasure"),
            ):
                found[f"{method} {path}"] = clinic(method, path, json={}).status_code
    return found


def answer_apart(folder: Path, name: str, hidden: tuple[str, ...]) -> None:
    """Write the answers of a program without these features, or what went wrong, from a process of its own."""
    child = os.fork()
    if child != 0:
        os.waitpid(child, 0)
        return
    try:
        hide(*hidden)
        (folder / f"{name}.json").write_text(json.dumps(answers(folder / name)))
    except BaseException:
        (folder / f"{name}.json").write_text(json.dumps(traceback.format_exc()))
    finally:
        os._exit(0)


if __name__ == "__main__":
    import_all_but_features()
    gc.freeze()  # a fork need not look through what all share
    answer_apart(Path(sys.argv[1]), WHOLE, ())
    for number, each in enumerate(HIDDEN):
        answer_apart(Path(sys.argv[1]), str(number), each)
