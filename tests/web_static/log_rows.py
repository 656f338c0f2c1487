"""The rows of the log that the program writes: their names, and the names of their details, read from its code."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Final

from folders import ROOT

WRITERS: Final = {"write_log": 2, "log_once": 1}  # what appends a row: the place of the row's name among the arguments
CONSTANT: Final = re.compile(r'^([A-Z_][A-Z0-9_]*)(?:: [^=\n]+)? = "([^"\\]*)"', re.MULTILINE)  # a text of a module
NAME: Final = "what"  # the parameter of a function that passes the name of a row on

Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass
class LogRows:
    """What calls write."""

    names: set[str] = field(default_factory=set)
    details: set[str] = field(default_factory=set)
    unread: list[str] = field(default_factory=list)  # calls whose row has a name that this module does not find


@cache
def log_rows() -> LogRows:
    """Return what the calls in app/ write, those of functions that pass a name on to `write_log` among them.

    A call of those stands in a module that names one of `WRITERS`.
    """
    texts = {file: file.read_text(encoding="utf-8") for file in sorted((ROOT / "app").rglob("*.py"))}
    modules = {file: ast.parse(text) for file, text in texts.items() if any(name in text for name in WRITERS)}
    constants = dict(each for text in texts.values() for each in CONSTANT.findall(text))
    rows = LogRows()
    for file, tree in modules.items():
        for call, place, function in _calls(tree):
            where = f"{file.relative_to(ROOT)}:{call.lineno}"
            name = call.args[place] if place < len(call.args) else None
            names = [] if name is None else _texts(name, function, constants)
            rows.names |= set(names)
            rows.details |= _details(call, function)
            if not names and not (isinstance(name, ast.Name) and name.id in _parameters(function)):
                rows.unread.append(where)
    return rows


def _calls(tree: ast.Module) -> Iterator[tuple[ast.Call, int, Function]]:
    """Yield each call that writes a row, the place of its name, and the outermost function around it.

    A function of the module that has a parameter `what`, and calls `write_log`, writes a row as well: also where it is
    the first argument of a call, as of `asyncio.to_thread`.
    """
    writers = dict(WRITERS)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and _passes_on(node):
            names = _parameters(node)
            writers[node.name] = names.index(NAME) - (names[0] == "self")
    for function in _outermost(tree):
        for node in ast.walk(function):
            if isinstance(node, ast.Call):
                if (name := _called(node.func)) in writers and name not in _parameters(function):
                    yield node, writers[name], function
                elif node.args and (name := _called(node.args[0])) in writers:
                    yield node, writers[name] + 1, function


def _passes_on(function: Function) -> bool:
    return NAME in _parameters(function) and any(
        isinstance(each, ast.Call) and _called(each.func) in WRITERS for each in ast.walk(function)
    )


def _outermost(tree: ast.Module) -> Iterator[Function]:
    for node in tree.body:
        for part in node.body if isinstance(node, ast.ClassDef) else [node]:
            if isinstance(part, ast.FunctionDef | ast.AsyncFunctionDef):
                yield part


def _called(node: ast.expr) -> str:
    """Return the name of what is called: `change` of `controls.change`."""
    return node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ""


def _parameters(function: Function) -> list[str]:
    return [each.arg for each in (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs)]


def _texts(value: ast.expr, function: Function, constants: dict[str, str]) -> list[str]:
    """Return the texts that a value can be: it stands there, in a constant, or in a variable of the function."""
    if isinstance(value, ast.IfExp):
        return _texts(value.body, function, constants) + _texts(value.orelse, function, constants)
    if isinstance(value, ast.Constant) and isinstance(value.value, str):
        return [value.value]
    if isinstance(value, ast.Name):
        assigned = [text for each in _assigned(value.id, function) for text in _texts(each, function, constants)]
        return assigned or [text for name, text in constants.items() if name == value.id]
    return []


def _assigned(name: str, function: Function) -> list[ast.expr]:
    return [
        node.value
        for node in ast.walk(function)
        if isinstance(node, ast.Assign) and any(isinstance(each, ast.Name) and each.id == name for each in node.targets)
    ]


def _details(call: ast.Call, function: Function) -> set[str]:
    """Return the names of details: those of the call, and the keys of documents in the function when it takes some."""
    names = {each.arg for each in call.keywords if each.arg is not None}
    passed = [each.value for each in call.keywords]
    documents = [
        *passed,
        *(one for each in passed if isinstance(each, ast.Name) for one in _assigned(each.id, function)),
    ]
    return names | {
        key.value
        for document in documents
        for node in ast.walk(document)
        if isinstance(node, ast.Dict)
        for key in node.keys
        if isinstance(key, ast.Constant) and isinstance(key.value, str)
    }
