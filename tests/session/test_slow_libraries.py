"""What measuring imports inside its functions is loaded before a chair may move."""

import ast

from app.session.run_flow import SLOW_LIBRARIES
from folders import ROOT

MEASURING = ("calibration", "scoring", "signals")


def test_every_library_that_measuring_imports_late_is_loaded_early():
    late = set()
    for package in MEASURING:
        for file in sorted((ROOT / "app" / package).rglob("*.py")):
            functions = [node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.FunctionDef)]
            for node in (inner for function in functions for inner in ast.walk(function)):
                if isinstance(node, ast.ImportFrom):
                    late.add(node.module)
                elif isinstance(node, ast.Import):
                    late.update(name.name for name in node.names)
    assert late == set(SLOW_LIBRARIES)
