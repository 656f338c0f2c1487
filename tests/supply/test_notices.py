"""The notices of others' work in a wheel: each file of others has one, with the whole text of its licence."""

import re
import tomllib
from importlib.metadata import version
from pathlib import Path
from typing import Any

import pytest

import hatch_build
from app.cli import about
from folders import ROOT
from front_end_packages import RECORD, VENDOR, FetchError
from hatch_build import notices

WHEEL = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]["targets"]["wheel"]
SETTINGS: dict[str, Any] = WHEEL["hooks"]["custom"]
SHIPPED = [ROOT / name for name in (*WHEEL["packages"], *WHEEL["force-include"])]
FOREIGN = [*hatch_build.front_end_works(ROOT), *(hatch_build.Foreign(**one) for one in SETTINGS["foreign"])]
# What people write into a file that they give away, in its first lines; and kinds of files without lines.
MARKS = re.compile(rb"copyright|\(c\) \d|licen[cs]ed under|@licen[cs]e|spdx-licen[cs]e-identifier", re.IGNORECASE)
HEAD = 2000  # bytes
LICENCES = {"MIT": "MIT License", "OFL-1.1": "SIL OPEN FONT LICENSE Version 1.1", "Apache-2.0": "Apache License"}
FONTS = {".ttf", ".otf", ".woff", ".woff2"}


def test_every_file_of_others_that_a_wheel_holds_has_its_notice() -> None:
    files = [file for folder in SHIPPED for file in folder.rglob("*") if file.is_file()]
    assert len(files) > 500
    no_work = {ROOT / one.text for one in FOREIGN} | {ROOT / VENDOR / RECORD}
    marked = {
        file.relative_to(ROOT).as_posix()
        for file in files
        if file.suffix in FONTS or "vendor" in file.parts or MARKS.search(file.read_bytes()[:HEAD])
        if file not in no_work and file.suffix != ".pyc"
    }
    listed = re.findall(r"^Files: (.+)$", notices(ROOT, FOREIGN), flags=re.MULTILINE)
    assert sorted(", ".join(listed).split(", ")) == sorted(marked)


@pytest.mark.parametrize("one", FOREIGN, ids=lambda one: one.name)
def test_a_notice_has_the_whole_text_of_the_licence(one: hatch_build.Foreign) -> None:
    text = notices(ROOT, [one])
    assert (ROOT / one.text).read_text() in text
    assert f"Name: {one.name}\nVersion: {one.version}\nLicence: {one.licence}\nFiles: " in text
    assert LICENCES[one.licence] in text


def test_the_versions_are_those_of_the_files() -> None:
    versions = {one.name: one.version for one in FOREIGN}
    head = (ROOT / VENDOR / "uplot" / "uPlot.js").read_text()[:300]
    assert re.search(rf"\bv{re.escape(versions['uplot'])}\b", head)
    readme = (ROOT / "data/fonts/README.md").read_text()
    named = re.findall(r"fonts-noto-\w+ \d+", versions["Noto fonts, subsets"])
    assert len(named) == 2
    assert [each for each in named if each not in readme] == []


def test_what_is_named_and_not_there_is_no_wheel(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=re.escape(FOREIGN[-1].files)):
        notices(tmp_path, FOREIGN[-1:])


def test_a_compiled_wheel_has_the_notice_of_mypyc() -> None:
    text = hatch_build.notice_of_compiled()
    assert f"of mypy {version('mypy')}\nLicence: MIT\n" in text
    assert "Permission is hereby granted, free of charge" in text


def made_files() -> hatch_build.MadeFiles:
    """The hook of a build; it looks neither at the settings of a build nor at metadata."""
    nothing: Any = None
    return hatch_build.MadeFiles(str(ROOT), SETTINGS, nothing, nothing, "", "wheel")


def build_data() -> dict[str, Any]:
    return {"force_include": {}, "force_include_editable": {}}


@pytest.mark.parametrize(("kind", "key"), [("standard", "force_include"), ("editable", "force_include_editable")])
def test_the_build_puts_the_notices_into_the_package(monkeypatch: pytest.MonkeyPatch, kind: str, key: str) -> None:
    monkeypatch.setenv("BODYDRIVE_COMPILE", "no")
    made = build_data()
    hook = made_files()
    hook.initialize(kind, made)
    ((file, place),) = made[key].items()
    assert place == hatch_build.NOTICES == about.NOTICES
    assert Path(file).read_text() == notices(ROOT, FOREIGN)
    hook.finalize("standard", made, "")
    assert not Path(file).exists()


def test_a_build_without_the_packages_of_the_pages_ends_with_one_sentence(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refuse(_: Path) -> None:
        raise FetchError("There is no network.")

    monkeypatch.setattr(hatch_build, "ensure_packages", refuse)
    hook = made_files()
    with pytest.raises(SystemExit, match="1"):
        hook.initialize("editable", build_data())
    assert capsys.readouterr().err + capsys.readouterr().out == "There is no network.\n"
