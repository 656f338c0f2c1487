"""What the floor plan editor does to documents; its modules run in node, without a page."""

import shutil
import subprocess
from pathlib import Path

import pytest

from app.settings import static_folder


def test_documents_tools_and_undo(tmp_path):
    node = shutil.which("node")
    if node is None:
        pytest.skip("there is no node here: install Debian's package 'nodejs' to run the editor's tests")
    # Beside a file that says what browsers assume: these are modules.
    shutil.copytree(static_folder() / "js", tmp_path / "js")
    (tmp_path / "package.json").write_text('{"type": "module"}')
    script = Path(__file__).with_name("editor_logic.mjs")
    command = [node, str(script), str(tmp_path / "js" / "editor")]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert ran.returncode == 0, ran.stderr
    assert " hold" in ran.stdout
