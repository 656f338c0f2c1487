"""`python -m behaviour FILE`: write what the program does as hashes and texts, for comparing before and after a change.

A reordering of the code leaves the file as it was: `diff` of two files names what changed. Decodes and drives stand as
hashes of their numbers, the API as its document, and each page as its outline for screen readers, with digits masked.
"""

import hashlib
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from browser.eyes.photographs import owners_page
from browser.eyes.places import PLACES, put_back
from compiled.many_drives import drive, study

from app.api.app import create_app
from app.computing_process import ComputingProcess
from app.process.supervisor import ControlProcess
from app.settings import Settings
from bench.prior.knit import knit_people
from folders import SHARED

DRIVES = 20
SETTLE = 400  # ms until a page has drawn what it reads
MAPS = ("pca", "guided", "prior", "best")
SOMEBODY, OTHERS = "bend90_p01", tuple(f"bend90_p{number:02d}" for number in range(3, 11))
KNIT = SHARED / "data" / "knit_people"


def command(folder: Path, *words: str) -> str:
    """Return what `bodydrive` with these words prints, run in this folder."""
    program = str(Path(sys.executable).with_name("bodydrive"))
    run = subprocess.run([program, *words], cwd=folder, check=False, capture_output=True, text=True)
    return re.sub(r" in \d+\.\d s", "", run.stdout + run.stderr)  # how long it took


def hashes(folder: Path) -> dict[str, str]:
    """Return the hash of each file in the folder, by its name."""
    files = sorted(file for file in folder.rglob("*") if file.is_file())
    return {str(file.relative_to(folder)): hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def command_line(folder: Path) -> dict[str, object]:
    """Return what the commands of the record print, and the hashes of the files that these commands write."""
    (folder / "path.csv").write_text("x,y\n0,0\n4,0\n4,3\n")
    (folder / "driven.csv").write_text(
        "t,x,y\n" + "".join(f"{i / 10},{min(i, 40) / 10},{max(0, i - 40) / 10}\n" for i in range(70))
    )
    printed = {"score": command(folder, "score", "driven.csv", "path.csv", "--json")}
    printed["study"] = command(folder, "study", "--out", "study", "--trials", "3", "--format", "none")
    printed |= calibrations(folder) if KNIT.exists() else {}
    return {"printed": printed, "files": hashes(folder)}


def calibrations(folder: Path) -> dict[str, str]:
    """Return what calibrating and decoding print, for each map, with a prior of other people."""
    layout = ("--layout", str(KNIT / "layout.json"))
    for wearer, file in zip(knit_people(), sorted(KNIT.glob("*.parquet")), strict=True):
        rows = (f"{prompt.start},{prompt.end},{prompt.joint}" for prompt in wearer.parts[0].prompts)
        (folder / f"{file.stem}.csv").write_text("\n".join(("start,end,joint", *rows)) + "\n")
    printed = {}
    for name in OTHERS:
        words = ("--prompts", f"{name}.csv", "--person", name[-3:], "--json")
        printed[f"prior {name}"] = command(
            folder, "prior", "add", "others.json", str(KNIT / f"{name}.parquet"), *layout, *words
        )
    signals = str(KNIT / f"{SOMEBODY}.parquet")
    for kind in MAPS:
        given = (
            "--prompts",
            f"{SOMEBODY}.csv",
            "--prior",
            "others.json",
            "--map",
            kind,
            "--out",
            f"{kind}.json",
            "--json",
        )
        printed[f"calibrate {kind}"] = command(folder, "calibrate", signals, *layout, *given)
        decode = ("--profile", f"{kind}.json", "--out", f"{kind} commands.csv", "--json")
        printed[f"decode {kind}"] = command(folder, "decode", signals, *decode)
    return printed


def openapi(folder: Path) -> dict[str, object]:
    """Return the document of the API."""
    return create_app(Settings(state=folder), ControlProcess.start, ComputingProcess()).openapi()


def outlines() -> dict[str, list[str]]:
    """Return every page in every state as people with screen readers meet it, one line an element, digits masked."""
    with owners_page() as (page, clinic):
        return {name: outline(page, clinic, name) for name in PLACES}


def outline(page, clinic, name: str) -> list[str]:
    """Return the outline of one place."""
    PLACES[name](page, clinic)
    page.wait_for_timeout(SETTLE)
    text = page.locator("body").aria_snapshot()
    put_back(clinic)
    return re.sub(r"\d+", "#", text).splitlines()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        record = {
            "drives": [drive(seed) for seed in range(DRIVES)],
            "studies": [study(1)],
            "command line": command_line(Path(folder)),
            "api": openapi(Path(folder) / "unused"),
        }
    record["pages"] = outlines()
    Path(sys.argv[1]).write_text(json.dumps(record, indent=1, ensure_ascii=False) + "\n")
