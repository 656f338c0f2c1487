"""Who may import whom: the table, held against the code; docs/architecture.md says why it has exceptions."""

import ast
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from app.cli.main import COMMANDS
from app.features import NEEDS
from folders import ROOT

FILES = sorted((ROOT / "app").rglob("*.py"))

LEAVES = "leaf"
PURE_CHAIN = tuple(
    f"pipeline.{name}"
    for name in (
        *("chain", "channel_health", "channel_substitution", "controls", "decoder", "frame_loss"),
        *("map_readings", "person_brakes", "projection", "return_doubt"),
        "movement_check",
        *("ramp", "safety_gate", "shaping", "stop_ramp"),
        "replay.batch",
    )
)
WEB_KERNEL = tuple(
    f"api.{name}"
    for name in (
        *("answers", "deps", "driving.clinic_places", "page_session", "parts", "own_address", "sign_in"),
        "replay.trajectories",
        *("package_download", "foreign_files", "interface_test_view", "routes.source_view", "live.screen_socket"),
    )
)
REGISTRATION = "features.registration"
# Packages, or single modules of them, that each package may import besides its own. A feature imports another one
# only through its service, and its line in app/features/__init__.py names it.
MAY_IMPORT = {
    LEAVES: (LEAVES,),
    "process": (LEAVES,),
    "recording": (LEAVES, "process.ring"),
    "signals": (LEAVES, "recording.reader"),
    "world": (LEAVES,),
    "hardware": (LEAVES, "process", "recording", "signals", "world"),
    "calibration": (LEAVES, "signals"),
    "pipeline": (LEAVES, "process", "recording", "signals", "hardware", "world", "calibration"),
    "scoring": (LEAVES, "recording", "signals", "world", "calibration", *PURE_CHAIN),
    "store": (LEAVES, "world", "calibration", "scoring", REGISTRATION),
    "session": (
        *(LEAVES, "process", "recording", "signals", "world", "calibration", *PURE_CHAIN, "scoring", "store"),
        *("hardware.chair.key", "hardware.chair.reasons", "hardware.chair.link_texts"),
        *("hardware.shirt.newest_frame", "hardware.configs"),
    ),
    "study": (
        *(LEAVES, "signals", "recording", "world", "calibration", *PURE_CHAIN, "scoring", "hardware.base"),
        *("hardware.body", "hardware.shirt.simulated_fabric", "hardware.chair.simulator"),
    ),
    "features": (
        *(LEAVES, "recording", "signals", "world", "calibration", "scoring", "store", "session", "figures"),
        *WEB_KERNEL,
    ),
    "figures": (LEAVES, "world", "scoring", "study"),
    "host": (LEAVES,),
    "scene": (LEAVES, "world"),
    "api": (
        *(
            LEAVES,
            "process",
            "signals.parquet_names",
            "signals.table_form",
            "signals.time_names",
            *("signals.bids_motion", "signals.import_options", "signals.joint_names", "signals.overview"),
            "world",
            "calibration",
            "scoring",
        ),
        *("recording.recorded_trajectory", "store", "session", "host", "scene"),
        *("hardware.configs", "hardware.addresses", "hardware.chair.key", "hardware.shirt.kind", REGISTRATION),
    ),
    "cli": (
        *(LEAVES, "process", "recording", "signals", "world", "hardware", "calibration", "pipeline", "scoring"),
        *("store", "session", "study", "figures", "host", "scene", "api", "features"),
    ),
}
FITTING = (
    *("calibration.fit", "calibration.guided", "calibration.gestures"),
    *("calibration.adaptation", "calibration.prior"),
)

HOME = {
    "fastapi": {"api", "features"},
    "starlette": {"api", "features"},
    "uvicorn": {"cli"},
    "markdown_it": {"api"},
    "viser": {"scene"},
    "trimesh": {"scene"},
    "sqlalchemy": {"store", "features"},
    "alembic": {"store"},
    "sklearn": {"calibration"},
    "typer": {"cli"},
    "matplotlib": {"figures"},
    "argon2": {"api"},
    "cyclonedds": {"hardware"},
    "segno": {"api", "cli"},
    "serial": {"hardware"},
    "ezdxf": {"world"},
    "msgspec": {"scene"},
    "cryptography": {"host", "features"},
    "pyrage": {"features"},
    "psutil": {"host"},
    "pylsl": {LEAVES},
    "brainflow": {"hardware"},
    "bleak": {"hardware"},
    "typst": {"features"},
}


def module_of(file: Path) -> str:
    return ".".join(file.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


MODULES = {module_of(file) for file in FILES}


def package_of(module: str) -> str:
    parts = module.split(".")
    return parts[1] if len(parts) > 1 and (ROOT / "app" / parts[1]).is_dir() else LEAVES


def statements(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield all statements of a module, also those within others; their expressions are far more."""
    waiting: list[ast.AST] = [tree]
    while waiting:
        node = waiting.pop()
        yield node
        for parts in ("body", "orelse", "handlers", "finalbody", "cases"):
            waiting += getattr(node, parts, ())


def imports_of(file: Path) -> set[str]:
    """Return the modules that a file names, also those inside functions."""
    found: set[str] = set()
    for node in statements(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found.update(name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            names = {f"{node.module}.{name.name}" for name in node.names}
            found.update((names & MODULES) or {node.module})
    return found


@cache
def imports_of_all() -> dict[str, set[str]]:
    """Return what each module of ours imports; for the tests only, so that other processes do not read all files."""
    return {module_of(file): imports_of(file) for file in FILES}


def may_import(importer: str, imported: str) -> bool:
    """Tell whether a module of one package may import this module of ours."""
    package, name = package_of(imported), imported.removeprefix("app.")
    if importer == "pipeline" and name.startswith(FITTING):
        return False
    return package == importer or any(
        package == LEAVES if entry == LEAVES else f"{name}.".startswith(f"{entry}.") for entry in MAY_IMPORT[importer]
    )


def test_imports_follow_the_table():
    assert {
        module: wrong
        for module, imports in imports_of_all().items()
        if (
            wrong := sorted(
                imported
                for imported in imports
                if imported.startswith("app.") and not may_import(package_of(module), imported)
            )
        )
    } == {}


def feature_of(module: str) -> str:
    """Return the feature that a module belongs to, empty for none."""
    parts = module.split(".")
    return parts[2] if parts[1:2] == ["features"] and len(parts) > 3 else ""


def test_a_feature_imports_another_only_through_a_service_that_it_needs():
    assert {
        module: wrong
        for module, imports in imports_of_all().items()
        if (own := feature_of(module))
        and (
            wrong := sorted(
                imported
                for imported in imports
                if (other := feature_of(imported)) not in {"", own}
                and (other not in NEEDS[own] or imported != f"app.features.{other}.service")
            )
        )
    } == {}


def test_the_registration_of_features_imports_none_of_them():
    kernel = ("app.features", f"app.{REGISTRATION}")
    assert [each for module in kernel for each in imports_of_all()[module] if feature_of(each)] == []


def test_one_library_has_one_home():
    assert {
        module: wrong
        for module, imports in imports_of_all().items()
        if (
            wrong := sorted(
                library
                for library in {imported.split(".")[0] for imported in imports}
                if library in HOME and package_of(module) not in HOME[library]
            )
        )
    } == {}


def test_one_module_reads_the_clock():
    found = {
        module for module, imports in imports_of_all().items() if any(each.split(".")[0] == "time" for each in imports)
    }
    assert found == {"app.clock"}


def reads_of_the_clock(file: Path) -> Iterator[str]:
    """Yield how a file reads the wall clock: `now` directly, `utc_now` by the function of app.clock."""
    text = file.read_text()
    if "now" not in text and "today" not in text:  # nothing to parse
        return
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Attribute) and node.attr in {"today", "utcnow"}:
            yield "now"
        elif isinstance(node, ast.Attribute) and node.attr == "now":
            of = node.value.attr if isinstance(node.value, ast.Attribute) else getattr(node.value, "id", "")
            if of == "datetime":
                yield "now"
        elif isinstance(node, ast.ImportFrom) and node.module == "app.clock":
            yield from (name.name for name in node.names if name.name == "utc_now")
        elif isinstance(node, ast.Attribute) and node.attr == "utc_now":
            yield "utc_now"


def test_the_wall_clock_is_read_in_one_module_and_where_the_chair_is_driven_for_labels_only():
    """Safety S16: a limit of time that went by the wall clock would change when that is set."""
    found = {module_of(file): set(reads_of_the_clock(file)) for file in FILES}
    assert {module for module, reads in found.items() if "now" in reads} == {"app.clock"}
    driving = {LEAVES, "process", "recording", "signals", "world", "hardware", "calibration", "pipeline", "scoring"}
    assert {module for module, reads in found.items() if "utc_now" in reads and package_of(module) in driving} == {
        "app.pipeline.runs",  # when a recording was made
        "app.calibration.fit.profile_fit",  # when a map was made
    }


def test_the_control_process_reaches_no_web_database_or_fitting_library():
    forbidden = [*HOME, "scipy", "shapely"]
    code = f"import sys, app.pipeline.process; print([m for m in {forbidden} if m in sys.modules])"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.strip() == "[]"


def test_the_kinds_of_shirts_load_no_library_of_a_device():
    """The web process reads their configurations; a driver imports its device's library when it is opened."""
    code = (
        "import sys, sysconfig\n"
        "before = set(sys.modules)\n"
        "import app.hardware.configs\n"
        "new = {name: getattr(sys.modules[name], '__file__', None) or '' for name in set(sys.modules) - before}\n"
        "installed = sysconfig.get_path('purelib')\n"
        "print(*sorted({name.partition('.')[0] for name, file in new.items() if file.startswith(installed)}))"
    )
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    allowed = {"annotated_types", "numpy", "pydantic", "pydantic_core", "typing_extensions", "typing_inspection"}
    assert set(seen.stdout.split()) - allowed == set()


def test_a_start_loads_no_library_that_only_some_functions_use():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["ruff"]["lint"]["flake8-tidy-imports"]
    heavy = set(settings["banned-module-level-imports"])
    modules = ["app.api.app", *sorted(module for module in MODULES if module.startswith("app.cli."))]
    code = f"import sys, {', '.join(modules)}; print(*{heavy} & set(sys.modules))"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.split() == []


def test_the_help_of_a_command_loads_no_database_no_server_and_no_numbers():
    modules = sorted({module for module, *_ in COMMANDS.values()})
    forbidden = ["sqlalchemy", "alembic", "fastapi", "uvicorn", "viser", "argon2", "numpy", "app.layout"]
    code = f"import sys, {', '.join(modules)}; print(*[m for m in {forbidden} if m in sys.modules])"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.split() == []
