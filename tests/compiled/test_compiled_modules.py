"""The modules that a wheel holds compiled: those with the mark can be compiled as they stand."""

import ast

from folders import ROOT
from hatch_build import marked_modules

MODULES = marked_modules(ROOT)


def classes_in(file):
    return [node for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))) if isinstance(node, ast.ClassDef)]


def test_no_class_of_plain_python_inherits_from_a_compiled_one():
    """Python refuses that when the module is imported, on the clinic's machine and not on the developer's."""
    compiled = {one.name for name in MODULES for one in classes_in(ROOT / name)}
    assert "SafetyGate" in compiled
    others = [file for file in (ROOT / "app").rglob("*.py") if file.relative_to(ROOT).as_posix() not in MODULES]
    heirs = [
        (file.name, one.name)
        for file in others
        for one in classes_in(file)
        for base in one.bases
        if isinstance(base, ast.Name) and base.id in compiled
    ]
    assert heirs == []
