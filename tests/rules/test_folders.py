"""The rules for folders and files: one subject each, few enough to be seen at once, named once."""

import re
import subprocess
from collections import defaultdict
from pathlib import PurePosixPath

from folders import ROOT

MOST_FILES = 40  # in a folder; more are two subjects
MOST_LINES = 400  # of a file
CODE = ("app/", "bench/", "tests/", "web_static/")
# File names that stand in several packages of `app`, each for one subject seen from several sides.
SAME_SUBJECT = {
    "adaptation": "of a map: the flow, the routes",
    "chairs": "real chairs: stored, chosen, the routes",
    "controls": "from gestures to commands: the step of the chain, the routes",
    "drives": "of a real chair: kept, the routes",
    "floorplan": "the document, the command",
    "limits": "of the clinic's owner: stored and loaded, the routes",
    "control_quality": "how well a trial was controlled: measured, kept, the routes",
    "movers": "what moves by itself in a place: its motion, its meshes",
    "packet": "the datagram of a device: shirt, chair",
    "people": "of the clinic: kept, the routes, the command",
    "page_session": "the session that a page shows: the rule, the check of each request",
    "patients": "kept, the routes",
    "plans": "the clinic's own floor plans: kept, the routes",
    "qr": "a text as a QR code: for a page, for a terminal",
    "recorded": "a role of the hardware that repeats a recording: body, head",
    "refusals": "what is refused: the exceptions, the answers",
    "replacements": "files that were replaced: kept, the routes",
    "replay": "of a recording: as a shirt, in 3D, the command",
    "runs": "a run: in the control process, in a session, kept",
    "shirt": "the shirt in use, the command",
    "simulator": "a role of the hardware without the device: shirt, head, chair",
}
OF_A_FEATURE = {"feature", "tables", "service", "routes"}  # the parts that a feature's folder is made of


def code_files() -> list[PurePosixPath]:
    """Return the files of code that git knows, or does not ignore."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    files = {PurePosixPath(name) for name in listed.stdout.splitlines() if name.startswith(CODE)}
    return sorted(file for file in files if (ROOT / file).is_file())


FILES = code_files()


def test_a_folder_holds_one_subject():
    count = defaultdict(int)
    for file in FILES:
        count[str(file.parent)] += 1
    assert {folder: files for folder, files in count.items() if files > MOST_FILES} == {}


def test_a_file_holds_one_subject():
    code = [file for file in FILES if file.suffix in {".py", ".js", ".css"}]
    lines = {str(file): len((ROOT / file).read_text(encoding="utf-8").splitlines()) for file in code}
    assert {file: count for file, count in lines.items() if count > MOST_LINES} == {}


def test_a_file_name_stands_for_one_subject():
    places = defaultdict(list)
    for file in FILES:
        is_of_slice = file.match("app/features/*/*.py") and file.stem in OF_A_FEATURE
        if file.parts[0] == "app" and file.suffix == ".py" and file.stem != "__init__" and not is_of_slice:
            places[file.stem].append(str(file))
    repeated = {name: files for name, files in places.items() if len(files) > 1}
    assert {name: files for name, files in repeated.items() if name not in SAME_SUBJECT} == {}
    assert set(SAME_SUBJECT) <= set(repeated)  # no entry without need


def test_a_test_has_a_name_of_its_own():
    """Test files are imported by their names alone, so that two of one name cannot be collected together."""
    tests = [file for file in FILES if file.parts[0] == "tests" and file.name.startswith("test_")]
    places = defaultdict(list)
    for file in tests:
        places[file.name].append(str(file))
    assert {name: files for name, files in places.items() if len(files) > 1} == {}


def test_a_class_name_has_one_meaning() -> None:
    """Who reads a name knows which class is meant."""
    places: dict[str, list[str]] = defaultdict(list)
    for file in (ROOT / "app").rglob("*.py"):
        for name in re.findall(r"^ *class (\w+)[(:\[]", file.read_text(encoding="utf-8"), re.MULTILINE):
            places[name].append(str(file.relative_to(ROOT)))
    assert {name: files for name, files in places.items() if len(files) > 1} == {}
