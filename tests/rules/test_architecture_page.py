"""The page docs/architecture.md: the files that it names exist, and each folder has its paragraph."""

import re

from folders import ROOT

PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
TOP = ("app", "bench", "data", "docs", "examples", "tests", "types", "web_static")
NAME = re.compile(rf"`((?:{'|'.join(TOP)})/[\w./]*)`")
NAMED = NAME.findall(PAGE)
QUESTIONS = re.findall(r"^\| (.+\?) \| `(.+)` \|$", PAGE, flags=re.MULTILINE)
LEAST_QUESTIONS = 25
AREAS = (
    *("app/pipeline/", "app/hardware/", "app/calibration/", "app/session/", "app/store/", "app/api/", "app/scene/"),
    *("web_static/js/pages/", "tests/", "bench/"),
)


def test_every_file_and_folder_that_the_page_names_exists():
    assert [name for name in NAMED if not (ROOT / name).exists()] == []
    assert [name for name in NAMED if name.endswith("/") != (ROOT / name).is_dir()] == []


def test_every_file_and_every_name_in_the_code_that_another_page_names_exists():
    pages = sorted((ROOT / "docs").rglob("*.md"))
    texts = [(page.name, page.read_text(encoding="utf-8")) for page in pages]
    assert len(pages) > 1
    assert [(page, name) for page, text in texts for name in NAME.findall(text) if not (ROOT / name).exists()] == []
    dotted = [(page, name) for page, text in texts for name in re.findall(r"`((?:app|bench)(?:\.\w+)+)`", text)]
    assert dotted
    assert [(page, name) for page, name in dotted if not is_in_code(name)] == []


def is_in_code(dotted: str) -> bool:
    """Return whether a dotted name is a module, or a name in one."""
    *module, last = dotted.split(".")
    if (ROOT / dotted.replace(".", "/")).with_suffix(".py").is_file():
        return True
    file = ROOT.joinpath(*module).with_suffix(".py")
    return file.is_file() and re.search(rf"\b{last}\b", file.read_text(encoding="utf-8")) is not None


def test_every_folder_has_its_paragraph():
    paragraphs = re.findall(r"^\*\*`([\w/]+)/`\*\*", PAGE, flags=re.MULTILINE)
    folders = {file.parent.relative_to(ROOT).as_posix() for file in (ROOT / "app").rglob("*.py")}
    packages = {"/".join(folder.split("/")[:2]) for folder in folders}
    assert sorted(paragraphs) == sorted({*packages, "bench", "data", "examples", "tests", "web_static"})
    named = {name.rstrip("/") for name in NAMED}
    assert sorted(folders - named) == []


def test_the_questions_name_one_file_each_over_all_areas():
    assert len(QUESTIONS) >= LEAST_QUESTIONS
    assert [answer for _, answer in QUESTIONS if not (ROOT / answer).is_file()] == []
    assert [area for area in AREAS if not any(answer.startswith(area) for _, answer in QUESTIONS)] == []
