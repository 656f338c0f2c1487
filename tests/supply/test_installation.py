"""How the Makefile and the page for administrators install: only what has the digest that requirements/ names."""

import re
import shlex
import subprocess
import sys
import zipfile
from hashlib import sha256
from pathlib import Path

import pytest

from folders import ROOT

PAGE = (ROOT / "docs" / "administrators.md").read_text(encoding="utf-8")


def installing_lines() -> list[list[str]]:
    """Return the words of every command of the Makefile that installs."""
    targets = ("demo", "check", "safety", "compiled", "pins")
    words = ["make", "--dry-run", "--always-make", "--no-print-directory", *targets]
    shown = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [shlex.split(line) for line in shown.splitlines() if "pip install" in line]


def lines_of_page() -> list[list[str]]:
    return [shlex.split(line) for line in re.findall(r"^\S*\bpip .+$", PAGE, flags=re.MULTILINE)]


LINES = [*installing_lines(), *lines_of_page()]


def test_the_makefile_and_the_page_install() -> None:
    lists = {word for words in LINES for word in words if word.startswith("requirements/")}
    assert lists >= {f"requirements/{name}.txt" for name in ("run", "build", "compile", "test", "safety", "pins")}


@pytest.mark.parametrize("words", LINES, ids=" ".join)
def test_a_command_looks_at_digests_or_takes_nothing_from_elsewhere(words: list[str]) -> None:
    options = set(words)
    assert "--require-hashes" in options or {"--no-index", "--no-deps"} <= options
    assert "install" not in options or "--editable" not in options or "--no-build-isolation" in options
    assert "wheel" not in options or "--no-build-isolation" in options


@pytest.fixture
def packages(tmp_path: Path) -> Path:
    """A folder with the wheel of a package that has one module."""
    folder = tmp_path / "packages"
    folder.mkdir()
    about = "Metadata-Version: 2.1\nName: tiny\nVersion: 1\n"
    with zipfile.ZipFile(folder / "tiny-1-py3-none-any.whl", "w") as archive:
        archive.writestr("tiny.py", "")
        archive.writestr("tiny-1.dist-info/METADATA", about)
        archive.writestr("tiny-1.dist-info/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        archive.writestr("tiny-1.dist-info/RECORD", "")
    return folder


@pytest.mark.parametrize("is_right", [True, False])
def test_a_wheel_with_another_digest_is_refused(packages: Path, tmp_path: Path, is_right: bool) -> None:
    content = (packages / "tiny-1-py3-none-any.whl").read_bytes()
    digest = sha256(content if is_right else content + b"!").hexdigest()
    asked = tmp_path / "run.txt"
    asked.write_text(f"tiny==1 \\\n    --hash=sha256:{digest}\n")
    (words, *_) = [words for words in LINES if "requirements/build.txt" in words]
    given = [word for word in words[words.index("install") + 1 :] if not word.startswith("requirements/")]
    place = ("--no-index", "--find-links", packages, "--target", tmp_path / "installed")
    pip = [sys.executable, "-m", "pip", "install", *given, asked, *place]
    ended = subprocess.run([*map(str, pip)], capture_output=True, text=True, check=False)
    assert (ended.returncode == 0) == is_right, ended.stderr
    assert (tmp_path / "installed" / "tiny.py").is_file() == is_right
    if not is_right:
        assert "DO NOT MATCH THE HASHES" in ended.stderr
