"""A file whose only importer stands beside it belongs into that importer: five scraps are one subject cut up.

Features are read by the names of their parts, commands, drivers and child processes by a name in a text: such modules
are imported from elsewhere, and count as that.
"""

import ast
import re
from collections import defaultdict
from functools import cache

from rules.test_folders import MOST_LINES, OF_A_FEATURE
from rules.test_imports import FILES, MODULES, imports_of_all, module_of

from app.features.registration import features
from folders import ROOT

TESTED = "a subject of its own, with tests of its own"
TOO_LONG = "with its importer it would be longer than a file may be"
# Files that stay beside their only importer, by the reason.
EXCEPTIONS: dict[str, tuple[str, ...]] = {
    TESTED: (
        *("app.api.docs_pages", "app.api.proxy", "app.api.request_bodies"),
        *("app.calibration.prior.forecasts", "app.cli.calibration.map_choice", "app.cli.demonstration"),
        *("app.cli.server", "app.cli.study.study_runs", "app.scene.models.glb_check"),
        *("app.scoring.map_losses.gesture_trial", "app.scoring.retention"),
        *("app.features.exports.bids_form", "app.features.exports.fhir_form", "app.features.exports.xdf_form"),
        *("app.features.exports.measure_tables", "app.features.reports.interface_test_report"),
        *("app.features.reports.task_report", "app.hardware.body.cued_body", "app.hardware.body.driver"),
        *("app.hardware.body.manoeuvres", "app.hardware.chair.receiver_loop", "app.hardware.chair.telemetry"),
        *("app.hardware.head.flock_record", "app.hardware.shirt.lateness", "app.hardware.shirt.sequence"),
        *("app.host.authority", "app.pipeline.frame_rate", "app.pipeline.head_tracking"),
        *("app.pipeline.movement_check", "app.pipeline.runs", "app.pipeline.screen_pause", "app.recording.arrow"),
        *("app.scene.meshes.furniture", "app.scene.meshes.ground", "app.scene.meshes.interior"),
        *("app.scene.meshes.walls", "app.scene.unlit_glb", "app.scoring.decimation", "app.session.adaptation_reading"),
        *("app.world.imports.dxf", "app.world.imports.dxf_lines"),
        "app.world.imports.image",
    ),
    TOO_LONG: (
        "app.cli.calibration.prior_files",
        "app.features.reports.drawings",
        "app.pipeline.commands",
        "app.scene.models.glb_geometry",
    ),
    "the application puts its parts together; the answers to exceptions are read apart": ("app.api.refusals",),
    "whether a patient may be replaced is read apart from how a file is unpacked": (
        "app.features.archive.imported_patient",
    ),
    "the words of map and controls are changed apart from the composition of a report": (
        "app.features.reports.condition",
    ),
    "the arithmetic of every frame is measured and compiled apart from the decoder": ("app.pipeline.map_readings",),
    "two plots of the clinician's panel are another subject than the scene of a session": ("app.scene.plots",),
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


def test_each_reason_of_an_exception_holds() -> None:
    tests = "\n".join(file.read_text(encoding="utf-8") for file in sorted((ROOT / "tests").rglob("test_*.py")))
    importers = beside_their_only_importer()
    assert [
        module
        for module in EXCEPTIONS[TESTED]
        for folder, _, name in [module.rpartition(".")]
        if not re.search(rf"from {module} import|from {folder} import [^\n]*\b{name}\b", tests)
    ] == []
    short = {module: lines_of(module) + lines_of(importers[module]) for module in EXCEPTIONS[TOO_LONG]}
    assert {module: lines for module, lines in short.items() if lines <= MOST_LINES} == {}
