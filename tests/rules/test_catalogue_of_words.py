"""Sentences for people stand in the catalogue of words, never in code (docs/translating.md)."""

import ast
import re
from collections.abc import Iterator

from rules.test_imports import FILES

from folders import ROOT

REFUSALS = {
    *("CommandRefused", "Conflict", "DiskFull", "HTTPException", "HardwareError", "InputError", "NotFound"),
    *("OtherClinicRow", "PatientHere", "Refusal", "Unavailable"),
}
SENTENCE = re.compile(r"[A-Z“][^\n]* [^\n]* [^\n]*[.!]")
FOR_DEVELOPERS = {"description", "summary"}  # keywords: of programs that people do not start, of OpenAPI
LOGS = {"logger", "logging"}
HELPS = {"help", "short_help", "epilog"}  # keywords of typer
# Files whose sentences nobody translates, each with the reason.
ELSEWHERE = {
    "app/hardware/chair/receive.py": "runs alone on the board of a chair",
    "app/hardware/chair/chair_document.py": "runs alone on the board of a chair",
    "app/hardware/chair/chair_measure.py": "runs alone on the board of a chair",
    "app/hardware/chair/joystick_drive.py": "runs alone on the board of a chair",
    "app/hardware/chair/outputs.py": "runs alone on the board of a chair",
    "app/hardware/chair/reasons.py": "runs alone on the board of a chair; the catalogue has the same",
    "app/hardware/chair/ros2.py": "runs alone on the board of a chair",
    "app/hardware/chair/whill.py": "runs alone on the board of a chair",
    "app/api/page_session.py": "reasons of routes, for developers",
    "app/api/routes/stop.py": "reasons of routes, for developers",
    "app/api/patient_screen/routes.py": "reasons of routes, for developers",
    "app/features/sharing/shared_page.py": "reasons of routes, for developers",
}


def texts_in(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Yield line and text of each string for people; those that document, log or describe a field are none."""
    left_out: set[ast.AST] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant | ast.JoinedStr):
            left_out.add(node.value)  # a docstring, or the description of a constant
        elif isinstance(node, ast.Call):
            left_out |= {keyword.value for keyword in node.keywords if keyword.arg in FOR_DEVELOPERS}
            of: ast.expr = node.func
            while isinstance(of, ast.Attribute | ast.Call):
                of = of.value if isinstance(of, ast.Attribute) else of.func
            if isinstance(of, ast.Name) and of.id in LOGS:
                left_out |= set(node.args)
        elif isinstance(node, ast.JoinedStr):
            left_out |= set(node.values)
    for node in ast.walk(tree):
        if node in left_out:
            continue
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.lineno, node.value
        elif isinstance(node, ast.JoinedStr):
            parts = [str(part.value) if isinstance(part, ast.Constant) else "X" for part in node.values]
            yield node.lineno, "".join(parts)


def test_no_sentence_stands_in_code() -> None:
    found = {}
    for file in FILES:
        sentences = [(line, text) for line, text in texts_in(ast.parse(file.read_text())) if SENTENCE.fullmatch(text)]
        if sentences:
            found[str(file.relative_to(ROOT))] = sentences
    assert {path: sentences for path, sentences in found.items() if path not in ELSEWHERE} == {}
    assert ELSEWHERE.keys() <= found.keys()


def has_words(node: ast.expr) -> bool:
    """Return whether an argument is a string with words of its own, not one that only joins texts."""
    parts = node.values if isinstance(node, ast.JoinedStr) else [node]
    return any(isinstance(part, ast.Constant) and re.search("[a-z]", str(part.value)) for part in parts)


def test_a_refusal_is_a_text() -> None:
    found = [
        (str(file.relative_to(ROOT)), node.lineno)
        for file in FILES
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in REFUSALS
        if any(map(has_words, node.args))
    ]
    assert [place for place in found if place[0] not in ELSEWHERE] == []


def test_a_help_of_the_command_line_is_from_the_catalogue() -> None:
    found = [
        (str(file.relative_to(ROOT)), node.value.lineno)
        for file in FILES
        if file.is_relative_to(ROOT / "app" / "cli")
        for node in ast.walk(ast.parse(file.read_text()))
        if isinstance(node, ast.keyword) and node.arg in HELPS and not ast.unparse(node.value).startswith("help_text(")
    ]
    assert found == []
