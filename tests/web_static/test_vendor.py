"""The scripts of others that the pages load are those of their packages, as package-lock.json names them."""

import json

import pytest

from app.settings import static_folder
from folders import ROOT
from needed import lacks

PACKAGE = "node_modules/plotly.js-basic-dist-min"
COPIES = {"plotly-basic.min.js": "plotly-basic.min.js", "plotly-LICENSE.txt": "LICENSE"}


def test_the_folder_holds_what_make_vendor_copies_and_nothing_else() -> None:
    assert {file.name for file in (static_folder() / "vendor").iterdir()} == set(COPIES)


@pytest.mark.parametrize(("copy", "original"), COPIES.items())
def test_a_copy_is_the_file_of_the_package(copy: str, original: str) -> None:
    file = ROOT / PACKAGE / original
    if not file.is_file():
        lacks("The packages of npm are not installed: run `make check`.")
    assert (static_folder() / "vendor" / copy).read_bytes() == file.read_bytes()


def test_the_script_has_the_version_of_the_lock_file() -> None:
    lock = json.loads((ROOT / "package-lock.json").read_text())["packages"][PACKAGE]
    assert lock["integrity"].startswith("sha512-")
    head = (static_folder() / "vendor" / "plotly-basic.min.js").read_text()[:200]
    assert f" v{lock['version']}\n" in head
