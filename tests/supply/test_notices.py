"""The notices of others' work in a wheel: each file of others has one, with the whole text of its licence."""

import re
import sys
import tomllib
from importlib.metadata import version
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from folders import ROOT

SETTINGS = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
FOREIGN: list[dict[str, str]] = SETTINGS["hooks"]["custom"]["foreign"]
SHIPPED = [ROOT / name for name in (*SETTINGS["packages"], *SETTINGS["force-include"])]
# What people write into a file that they give away, in its first lines; and kinds of files without lines.
MARKS = re.compile(rb"copyright|\(c\) \d|licen[cs]ed under|@licen[cs]e|spdx-licen[cs]e-identifier", re.IGNORECASE)
HEAD = 2000  # bytes
FONTS = {".ttf", ".otf", ".woff", ".woff2"}


@pytest.fixture(scope="module")
def build() -> ModuleType:
    """hatch_build.py, as a module."""
    spec = spec_from_file_location("hatch_build", ROOT / "hatch_build.py")
    assert spec
    assert spec.loader
    module = module_from_spec(spec)
    sys.modules["hatch_build"] = module
    spec.loader.exec_module(module)
    return module


def notices_of(build: ModuleType, root: Path, foreign: list[dict[str, str]]) -> str:
    return str(build.notices(root, [build.Foreign(**one) for one in foreign]))


def test_every_file_of_others_that_a_wheel_holds_has_its_notice(build: ModuleType) -> None:
    files = [file for folder in SHIPPED for file in folder.rglob("*") if file.is_file()]
    assert len(files) > 500
    texts = {ROOT / one["text"] for one in FOREIGN}
    marked = {
        file.relative_to(ROOT).as_posix()
        for file in files
        if file.suffix in FONTS or "vendor" in file.parts or MARKS.search(file.read_bytes()[:HEAD])
        if file not in texts and file.suffix != ".pyc"
    }
    listed = re.findall(r"^Files: (.+)$", notices_of(build, ROOT, FOREIGN), flags=re.MULTILINE)
    assert sorted(", ".join(listed).split(", ")) == sorted(marked)


@pytest.mark.parametrize("one", FOREIGN, ids=lambda one: one["name"])
def test_a_notice_has_the_whole_text_of_the_licence(build: ModuleType, one: dict[str, str]) -> None:
    text = notices_of(build, ROOT, [one])
    assert (ROOT / one["text"]).read_text() in text
    assert f"{one['name']} {one['version']}\nLicence: {one['licence']}\n" in text
    assert {"MIT": "MIT License", "OFL-1.1": "SIL OPEN FONT LICENSE Version 1.1"}[one["licence"]] in text


def test_the_versions_are_those_of_the_files() -> None:
    plotly, fonts = FOREIGN
    head = (ROOT / "web_static/vendor/plotly-basic.min.js").read_text()[:200]
    assert f" v{plotly['version']}\n" in head
    readme = (ROOT / "data/fonts/README.md").read_text()
    named = re.findall(r"fonts-noto-\w+ \d+", fonts["version"])
    assert len(named) == 2
    assert [each for each in named if each not in readme] == []


def test_what_is_named_and_not_there_is_no_wheel(build: ModuleType, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=re.escape(FOREIGN[0]["files"])):
        notices_of(build, tmp_path, FOREIGN[:1])


def test_a_compiled_wheel_has_the_notice_of_mypyc(build: ModuleType) -> None:
    text = build.notice_of_compiled()
    assert f"of mypy {version('mypy')}\nLicence: MIT\n" in text
    assert "Permission is hereby granted, free of charge" in text


def build_data() -> dict[str, Any]:
    return {"force_include": {}, "force_include_editable": {}}


@pytest.mark.parametrize(("kind", "key"), [("standard", "force_include"), ("editable", "force_include_editable")])
def test_the_build_puts_the_notices_into_the_package(
    build: ModuleType, monkeypatch: pytest.MonkeyPatch, kind: str, key: str
) -> None:
    monkeypatch.setenv("BODYDRIVE_COMPILE", "no")
    made = build_data()
    hook = build.MadeFiles(str(ROOT), SETTINGS["hooks"]["custom"], None, None, "", "wheel")
    hook.initialize(kind, made)
    ((file, place),) = made[key].items()
    assert place == build.NOTICES
    assert Path(file).read_text() == notices_of(build, ROOT, FOREIGN)
    hook.finalize("standard", made, "")
    assert not Path(file).exists()
