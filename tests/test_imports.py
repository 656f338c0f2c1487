"""The import table of docs/architecture.md, held against the code."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from folders import ROOT

FILES = sorted((ROOT / "app").rglob("*.py"))

LEAVES = "leaf"
PURE_PIPELINE = {
    f"app.pipeline.{name}"
    for name in ("chain", "batch", "brakes", "safety", "decoder", "controls", "shaping", "health")
}
FITTING = {f"app.calibration.{name}" for name in ("fit", "guided", "pca", "quality")}
PURE_HARDWARE = (
    "app.hardware.body",
    "app.hardware.shirt.fabric",
    "app.hardware.shirt.standard",
    "app.hardware.shirt.newest",
    "app.hardware.chair.simulator",
    "app.hardware.chair.key",
    "app.hardware.chair.reasons",
    "app.hardware.base",
    "app.hardware.registry",
)
API_HARDWARE = ("app.hardware.configs", "app.hardware.places", "app.hardware.chair.key")

MAY_IMPORT = {
    LEAVES: {LEAVES},
    "world": {LEAVES},
    "hardware": {LEAVES, "world"},
    "calibration": {LEAVES},
    "pipeline": {LEAVES, "hardware", "world", "calibration"},
    "session": {LEAVES, "world", "calibration", "pipeline", "hardware"},
    "scene": {LEAVES, "world"},
    "api": {LEAVES, "world", "calibration", "session", "scene", "hardware"},
    "bench": {LEAVES, "world", "hardware", "calibration", "pipeline", "session", "scene", "api"},
    "cli": {LEAVES, "world", "hardware", "calibration", "pipeline", "session", "scene", "api", "bench"},
}

HOME = {
    "fastapi": {"api"},
    "starlette": {"api"},
    "uvicorn": {"cli"},
    "viser": {"scene"},
    "trimesh": {"scene"},
    "sqlalchemy": {"session"},
    "alembic": {"session"},
    "sklearn": {"calibration"},
    "typer": {"cli"},
    "matplotlib": {"session"},
    "argon2": {"api"},
    "plotly": {"api"},
    "cyclonedds": {"hardware"},
    "segno": {"api", "cli"},
    "serial": {"hardware"},
    "ezdxf": {"world"},
    "statsmodels": {"session"},
    "msgspec": {"scene"},
    "zstandard": {"bench"},
}


def module_of(file: Path) -> str:
    return ".".join(file.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def package_of(module: str) -> str:
    parts = module.split(".")
    return parts[1] if len(parts) > 1 and (ROOT / "app" / parts[1]).is_dir() else LEAVES


def imports_of(file: Path) -> set[str]:
    """Return the modules that a file names, also those inside functions."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found.update(name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
            found.update(f"{node.module}.{name.name}" for name in node.names)
    return found


@pytest.mark.parametrize("file", FILES, ids=module_of)
def test_imports_follow_the_table(file):
    importer = package_of(module_of(file))
    for imported in imports_of(file):
        if imported.split(".")[0] != "app" or imported in {"app", "app.__version__"}:
            continue
        imported_package = package_of(imported)
        assert imported_package in MAY_IMPORT[importer] | {importer}, f"{module_of(file)} imports {imported}"
        if importer == "pipeline" and imported_package == "calibration":
            assert not any(imported.startswith(fitting) for fitting in FITTING), imported
        if importer == "session" and imported_package == "pipeline" and imported != "app.pipeline":
            assert any(imported.startswith(pure) for pure in PURE_PIPELINE), imported
        if importer == "session" and imported_package == "hardware":
            assert imported.startswith(PURE_HARDWARE), imported
        if importer == "api" and imported_package == "hardware":
            assert imported.startswith(API_HARDWARE), imported


@pytest.mark.parametrize("file", FILES, ids=module_of)
def test_one_library_has_one_home(file):
    importer = package_of(module_of(file))
    for imported in imports_of(file):
        library = imported.split(".")[0]
        if library in HOME:
            assert importer in HOME[library] | {"bench"}, f"{module_of(file)} imports {library}"
        if library == "time":
            assert module_of(file) == "app.clock", f"{module_of(file)} reads a clock of its own"


@pytest.mark.parametrize("file", FILES, ids=module_of)
def test_a_file_is_one_subject(file):
    assert len(file.read_text().splitlines()) <= 300


def test_the_control_process_reaches_no_web_database_or_fitting_library():
    forbidden = [*HOME, "scipy", "pandas", "shapely"]
    code = f"import sys, app.pipeline.process; print([m for m in {forbidden} if m in sys.modules])"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.strip() == "[]"
