"""Modules of `app/` hold constants only, class names mean one thing, and files have more than one importer."""

import ast
from collections import defaultdict
from collections.abc import Iterator
from functools import cache

from rules.test_folders import MOST_LINES, OF_A_FEATURE
from rules.test_imports import FILES, MODULES, imports_of_all, module_of

from app.features.registration import features
from folders import ROOT

# Made by a call and never changed afterwards.
CONSTANT_KINDS = ("getLogger", "APIRouter", "Typer", "ViewPage", "attrgetter")
# What must be one for the whole process, with its reason.
PROCESS_WIDE = {
    "app/hardware/chair/link.py: _sequence": "the numbers of commands go on when a chair is opened again",
    "app/isolated_reader.py: _one_at_a_time": "two readers at once could use twice the memory that is allowed",
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


def test_a_class_name_has_one_meaning() -> None:
    places: dict[str, list[str]] = defaultdict(list)
    for file in (ROOT / "app").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.ClassDef):
                places[node.name].append(str(file.relative_to(ROOT)))
    assert {name: files for name, files in places.items() if len(files) > 1} == {}


# A file whose only importer stands beside it belongs into that importer: five scraps are one subject cut up. Features
# are read by the names of their parts, commands, drivers and child processes by a name in a text: such modules are
# imported from elsewhere, and count as that.
TOO_LONG = "with its importer it would be longer than a file may be"
# Files that stay beside their only importer, by the reason.
EXCEPTIONS: dict[str, tuple[str, ...]] = {
    TOO_LONG: (
        *("app.cli.calibration.prior_files", "app.cli.server", "app.features.reports.drawings"),
        *("app.features.reports.measure_reports", "app.hardware.body.driver", "app.hardware.body.steering"),
        *("app.hardware.chair.telemetry", "app.host.authority", "app.pipeline.commands"),
        *("app.pipeline.movement_check", "app.pipeline.runs", "app.scene.meshes.furniture"),
        *("app.scene.meshes.walls", "app.scene.models.glb_geometry", "app.scene.plots", "app.scoring.decimation"),
        *("app.session.adaptation_reading", "app.world.imports.dxf_lines"),
    ),
    "the application puts its parts together; what a proxy says, and the answers to exceptions, are read apart": (
        "app.api.proxy",
        "app.api.refusals",
    ),
    "a file for each format of other programs": (
        *("app.features.exports.bids_form", "app.features.exports.fhir_form"),
        *("app.features.exports.xdf_form", "app.world.imports.dxf", "app.world.imports.image"),
    ),
    "what a device's counter and clock say of its frames is judged without the socket that they come by": (
        "app.hardware.shirt.frame_order",
    ),
    "the help of a command loads no library; what the command runs loads many": ("app.cli.study.study_runs",),
    "the arithmetic of every frame is measured and compiled apart from the decoder": ("app.pipeline.map_readings",),
    "what a receiver sends, when and where, is read apart from the loop that keeps its limits of time": (
        "app.hardware.chair.telemetry_sender",
    ),
}


def named_in_texts() -> set[str]:
    """Return the modules that some code names in a text: commands, child processes, drivers, routes of features."""
    found = {f"app.features.{name}.{routes}" for name, one in features().items() for routes in one.routes}
    for file in FILES:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and node.value in MODULES:
                found.add(node.value)
    return found


@cache
def beside_their_only_importer() -> dict[str, str]:
    """Return the modules whose only importer stands in their folder, each with that importer."""
    importers = defaultdict(set)
    for module, imports in imports_of_all().items():
        for imported in imports & MODULES:
            importers[imported].add(module)
    packages = {module_of(file) for file in FILES if file.stem == "__init__"}
    parts = {module_of(file) for file in FILES if file.match("app/features/*/*.py") and file.stem in OF_A_FEATURE}
    return {
        module: importer
        for module in sorted(MODULES - packages - parts - named_in_texts())
        if len(importers[module]) == 1
        for importer in importers[module]
        if importer.rpartition(".")[0] == module.rpartition(".")[0]
    }


def lines_of(module: str) -> int:
    return len((ROOT / module.replace(".", "/")).with_suffix(".py").read_text(encoding="utf-8").splitlines())


def test_a_file_whose_only_importer_stands_beside_it_is_in_that_importer() -> None:
    found, excepted = beside_their_only_importer(), {module for modules in EXCEPTIONS.values() for module in modules}
    assert {module: importer for module, importer in found.items() if module not in excepted} == {}
    assert excepted - found.keys() == set()  # no exception without need


def test_what_would_be_too_long_with_its_importer_is_excepted_for_that() -> None:
    importers = beside_their_only_importer()
    lines = {module: lines_of(module) + lines_of(importer) for module, importer in importers.items()}
    assert {module for module, count in lines.items() if count > MOST_LINES} == set(EXCEPTIONS[TOO_LONG])
