"""A module holds constants only: what changes belongs to an object that somebody made, and can make again."""

import ast
from collections.abc import Iterator

from folders import ROOT

# Made by a call and never changed afterwards.
CONSTANT_KINDS = ("getLogger", "APIRouter", "Typer", "ViewPage", "attrgetter")
# What must be one for the whole process, with its reason.
PROCESS_WIDE = {
    "app/hardware/chair/link.py: _sequence": "the numbers of commands go on when a chair is opened again",
    "app/isolated_reader.py: _one_at_a_time": "two readers at once could use twice the memory that is allowed",
    "app/texts.py: _language": "a context variable: each request and each thread has its own value",
    "app/scene/bridge_secret.py: _guarded": "viser asks a function of the module, not an object of ours",
}


def changeable_names(tree: ast.Module) -> Iterator[str]:
    """Yield the names at the top of a module that are written like variables, and hold what a call has made."""
    for node in tree.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and isinstance(node.value, ast.Call):
            maker = ast.unparse(node.value.func).rpartition(".")[2]
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (
                name.id
                for name in targets
                if isinstance(name, ast.Name) and name.id.islower() and maker not in CONSTANT_KINDS
            )


def test_no_module_holds_what_changes():
    found = {
        f"{file.relative_to(ROOT)}: {name}"
        for file in (ROOT / "app").rglob("*.py")
        for name in changeable_names(ast.parse(file.read_text()))
    }
    assert found == set(PROCESS_WIDE)


def test_a_lock_at_the_top_of_a_module_is_found():
    assert list(changeable_names(ast.parse("_saving = Lock()\nLIMIT = 3\n"))) == ["_saving"]
