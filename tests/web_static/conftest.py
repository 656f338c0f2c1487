"""Scripts that test the modules of web_static/js in node, without a page."""

import json
import shutil
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from served_reference import served_reference

from api_types import NODE
from app.api.pages import language_files
from app.settings import static_folder


@pytest.fixture(scope="session")
def modules_of(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Copies of web_static/js, of what it imports and the modules of a language, beside a package.json for node."""

    @cache
    def copied(language: str) -> Path:
        folder = tmp_path_factory.mktemp("modules")
        (folder / "package.json").write_text('{"type": "module"}')
        shutil.copytree(static_folder() / "vendor", folder / "vendor")
        scripts = Path(shutil.copytree(static_folder() / "js", folder / "js"))
        for name, content in language_files(static_folder(), language).items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content)
        return scripts

    return copied


@pytest.fixture(scope="session")
def reference_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file with what the pages look up, as the server answers it; `served.mjs` gives it to the modules."""
    file = tmp_path_factory.mktemp("reference") / "reference.json"
    file.write_text(served_reference(), encoding="utf-8")
    return file


@pytest.fixture(scope="session")
def run_script(modules_of: Callable[[str], Path]) -> Callable[..., str]:
    """Run a script of this folder, or of one below, with the folder of the modules, and return what it prints."""

    def run(name: str, *arguments: Path, language: str = "en") -> str:
        command = [NODE, Path(__file__).parent / name, modules_of(language), *arguments]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture
def answered(run_script: Callable[..., str], tmp_path: Path) -> Callable[..., Any]:
    """Run a script on a document, which it reads from a file, and return the document that it prints."""

    def run(name: str, given: Any, *arguments: Path) -> Any:
        file = tmp_path / "given.json"
        file.write_text(json.dumps(given), encoding="utf-8")
        return json.loads(run_script(name, *arguments, file))

    return run
