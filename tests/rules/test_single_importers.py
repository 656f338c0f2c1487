"""A file whose only importer stands beside it belongs into that importer: five scraps are one subject cut up.

Features are read by the names of their parts, commands, drivers and child processes by a name in a text: such modules
are imported from elsewhere, and count as that.
"""

import re
from collections import defaultdict
from functools import cache

from rules.test_folders import MOST_LINES, OF_A_FEATURE
from rules.test_imports import FILES, MODULES, imports_of_all, module_of

from app.features.registration import features
from folders import ROOT

TOO_LONG = "with its importer it would be longer than a file may be"
# Files that stay beside their only importer, by the reason.
EXCEPTIONS: dict[str, tuple[str, ...]] = {
    TOO_LONG: (
        "app.cli.calibration.prior_files",
        "app.cli.server",
        "app.features.reports.drawings",
        "app.features.reports.measure_reports",
        "app.hardware.body.driver",
        "app.hardware.body.steering",
        "app.hardware.chair.joystick_drive",
        "app.hardware.chair.telemetry",
        "app.hardware.chair.telemetry_sender",
        "app.hardware.chair.walker_page",
        "app.hardware.shirt.brainflow_library",
        "app.hardware.shirt.lsl_reception",
        "app.hardware.shirt.orientation_sensors.bluetooth_links",
        "app.hardware.shirt.orientation_sensors.slimevr_trackers",
        "app.hardware.shirt.serial_bytes",
        "app.host.authority",
        "app.pipeline.commands",
        "app.pipeline.movement_check",
        "app.pipeline.runs",
        "app.scene.meshes.doors",
        "app.scene.meshes.furniture",
        "app.scene.models.glb_geometry",
        "app.scene.plots",
        "app.scoring.decimation",
        "app.session.adaptation_reading",
        "app.signals.clock_times",
        "app.signals.text_table",
        "app.world.imports.dxf_lines",
    ),
    "the application puts its parts together; what surrounds every request, and the answers to exceptions, are apart": (
        "app.api.guard",
        "app.api.proxy",
        "app.api.refusals",
    ),
    "a file for each format of other programs": (
        "app.features.exports.bids_form",
        "app.features.exports.fhir_form",
        "app.features.exports.xdf_form",
        "app.world.imports.dxf",
        "app.world.imports.image",
    ),
    "tests use the emulated chair, too": ("app.hardware.chair.whill_emulator",),
    "how large a request may be is read apart from whose page may ask": ("app.api.body_limits",),
    "what is accepted of foreign files is read apart from the routes of the clinic's own plans": (
        "app.api.routes.plan_uploads",
    ),
    "the computing process reads a file for a draft, and loads neither routes nor database": (
        "app.features.layouts.drafts",
    ),
    "what is sent over LSL is made of ticks apart from the thread that sends it": ("app.features.lsl.outlets",),
    "the control process passes ids on and loads no catalogue": ("app.fluent_catalogue",),
    "the map of one joint is fitted apart from what a profile makes of all joints": ("app.calibration.fit.joint_fit",),
    "the help of a command loads no library; what the command runs loads many": ("app.cli.study.study_runs",),
    "the arithmetic of every frame is measured and compiled apart from the decoder": ("app.pipeline.map_readings",),
}


def named_in_texts() -> set[str]:
    """Return the modules that some code names in a text: commands, child processes, drivers, routes of features."""
    found = {f"app.features.{name}.{routes}" for name, one in features().items() for routes in one.routes}
    for file in FILES:
        found |= MODULES & set(re.findall(r'"([\w.]+)"', file.read_text(encoding="utf-8")))
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
