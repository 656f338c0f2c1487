"""`make safety`: what decides about motion, tested line by line and with faults put into it on purpose.

Runs the gate's own tests with branch coverage, a million generated steps among them, then changes the code in every way
that mutmut knows and looks whether a test notices. Works on a copy; writes docs/mutation.md; fails below its limits.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from importlib.metadata import version
from pathlib import Path

from folders import ROOT

REPORT = ROOT / "docs" / "mutation.md"
MODULES = ("safety_gate", "person_brakes", "ramp", "shaping", "stop_ramp")
TESTS = (
    *("test_safety_gate", "test_gate_states", "test_gate_levels", "test_person_brakes", "test_ramp", "test_shaping"),
    *("test_stop_ramp", "test_drive_modes"),
)
LEAST_SCORE = 0.95
STEPS = "1000000"
LONGEST = 900.0  # s for each part

# Changes that no test can notice, because they change nothing that the code does; each with its reason.
SAME = {
    "TURN_BUILD_UP * dt": "the constant is 1 s: to divide by it or to multiply with it is the same",
    "rate == 0.0 and": "only a short cut: the long way gives the same speed",
    "rate == 1.0 and": "only a short cut: the long way gives the same speed",
    "if not +self.bottom <= speed": "only a short cut: the long way gives the same speed",
    "if not -self.bottom < speed": "only a short cut: the long way gives the same speed",
    "<= speed < self.top:": "only a short cut: the long way gives the same speed",
    "elif wanted > 0.0": "a rate of 0 is the same on either side",
    "if rate >= self.acceleration": "at the acceleration itself the root changes nothing",
    "if (is_reached(": "only a short cut: the root gives the same rate",
    "/ (1.0 + SLACK)": "a rounding error, which SLACK forgives",
    "(1.0 - SLACK)": "a rounding error, which SLACK forgives",
    "(1.0 + SLACK) < headroom": "a rounding error, which SLACK forgives",
    "lowest < speed <= highest": "at the limit itself both ways lead to it",
    "lowest <= speed < highest": "at the limit itself both ways lead to it",
    "permitted >= softest": "at the limit itself it is the limit either way",
    "permitted <= hardest": "at the limit itself it is the limit either way",
    "following >= lowest": "at the limit itself it is the limit either way",
    "following <= highest": "at the limit itself it is the limit either way",
    "wanted >= -limit": "at the limit itself it is the limit either way",
    "wanted <= limit": "at the limit itself it is the limit either way",
    "wanted >= rate - change": "at the limit itself it is the limit either way",
    "wanted <= rate + change": "at the limit itself it is the limit either way",
    "self.acceleration <= wanted": "at the limit itself it is the limit either way",
    "self.deceleration <= wanted": "at the limit itself it is the limit either way",
    "is_permitted": "what may be done is handed back as asked; reckoned anew it is the same but for rounding",
    "abs(away)": "at the very border both ways lead to the target",
    "abs(target) >= abs(speed)": "from a speed to itself no limit is needed",
    "speed > 0.0:": "at standstill both branches give the same",
    "speed >= 1.0:": "for a forward speed the other branch is never above the acceleration",
    "(3.0 * self.jerk)": "stricter: begins to soften a little earlier before standstill",
    "headroom > 0.0": "without headroom the rate is 0 either way",
    "sample_rate > SLOW_SHIRT": "at exactly 60 Hz three periods are 50 ms, twelve are 200 ms",
    "speed >= 0 else": "at standstill both sides give standstill",
    '_since: float | None = ""': "set anew before it is read",
    "_stop_turn_rate = None": "set anew before it is read",
    "_stop_turn_rate = 1.0": "set anew before it is read",
    "self._unasked < self._longest": "a tick more or less of ten seconds; the tests that count ticks see the rest",
    "self._unasked + dt >= self._longest": "a tick more or less of ten seconds",
    '(parameters, "u2"), ': "both lists have one entry for each gesture",
    "in zip(gains, movements, ": "both lists have one entry for each gesture",
    "if sign >= 0 else self.high": "no axis that stands is asked for its brakes",
    "for sign in (-2, 0, 1)": "only its sign counts",
    "for sign in (2, -1)": "only its sign counts",
    "for sign in (1, -2)": "only its sign counts",
    "self.high if sign >= 0": "it is asked for 1 and -1 only",
    "min(1.0, *those)": "of the lowest sum only whether it is below 0 counts, and by how much",
    "for sign in (-1, 0, 2)": "only its sign counts",
    "_Push(min(1.0, *those)": "a lowest sum above 0 lowers nothing, as 0 does",
}


def main() -> int:
    """Run all of it; return 0 when every limit is kept."""
    with tempfile.TemporaryDirectory(prefix="bodydrive-mutation-") as folder:
        copy = Path(folder)
        for part in ("app", "tests", "data", "web_static/words"):
            shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__", ".*"))
        shutil.copy(ROOT / "pyproject.toml", copy)
        files = [f"tests/pipeline/{name}.py" for name in TESTS]
        covered = _coverage(copy, files)
        _run(copy, "mutmut", "run", "--max-children", str(os.cpu_count() or 1))
        results = _run(copy, "mutmut", "results", "--all", "true").stdout
        verdicts = dict(re.findall(r"^\s*(\S+__mutmut_\d+): (\w[\w ]*)$", results, re.MULTILINE))
        survivors = {name: _difference(copy, name) for name, verdict in verdicts.items() if verdict != "killed"}
    killed = len(verdicts) - len(survivors)
    score = killed / len(verdicts) if verdicts else 0.0
    unexplained = [name for name, (_, after) in survivors.items() if _reason(after) is None]
    REPORT.write_text(_report(covered, killed, len(verdicts), survivors))
    sys.stdout.write(f"{covered}{killed} of {len(verdicts)} changes noticed: {score:.1%}. {REPORT}\n")
    for name in unexplained:
        sys.stdout.write(f"Not noticed, and without a reason: {name} {survivors[name]}\n")
    return 0 if score >= LEAST_SCORE and not unexplained else 1


def _coverage(copy: Path, files: list[str]) -> str:
    names = [f"--cov=app.pipeline.{name}" for name in MODULES]
    limits = ["--cov-branch", "--cov-report=term", "--cov-fail-under=100"]
    shown = _run(copy, "pytest", "-q", *files, *names, *limits, BODYDRIVE_GATE_STEPS=STEPS).stdout
    return "".join(f"{line}\n" for line in shown.splitlines() if re.match(r"app/|TOTAL|Name", line))


def _run(folder: Path, module: str, *arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    done = subprocess.run(
        [sys.executable, "-m", module, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(folder), **environment},
        capture_output=True,
        text=True,
        timeout=LONGEST,
        check=False,
    )
    if done.returncode:
        sys.stdout.write(f"{done.stdout[-3000:]}\n{done.stderr[-3000:]}\n")
        raise SystemExit(f"{module} failed: see above.")
    return done


def _difference(copy: Path, name: str) -> tuple[str, str]:
    """Return the line before and after a change."""
    shown = _run(copy, "mutmut", "show", name).stdout
    lines = {sign: " ".join(re.findall(rf"^\{sign}(?!\{sign})\s*(.*)$", shown, re.MULTILINE)) for sign in "-+"}
    return lines["-"], lines["+"]


def _reason(after: str) -> str | None:
    return next((reason for part, reason in SAME.items() if part in after), None)


def _report(covered: str, killed: int, changes: int, survivors: dict[str, tuple[str, str]]) -> str:
    reasons = Counter((name.split(".")[2], _reason(after) or "**none**") for name, (_, after) in survivors.items())
    rows = "".join(f"| `{module}` | {reason} | {count} |\n" for (module, reason), count in reasons.items())
    modules = ", ".join(f"`app/pipeline/{name}.py`" for name in MODULES)
    return f"""# What the gate's tests would notice

Made by `make safety` (mutmut {version("mutmut")}, coverage {version("coverage")}); do not edit.

{modules} were run with {int(STEPS):,} generated steps and then changed in {changes} ways, one at a time.
The tests noticed {killed}: **{killed / changes:.1%}** (to be reached: {LEAST_SCORE:.0%}).

```
{covered}```

Not noticed, and why that is right; `tests/mutation.py` has the lines:

| module | reason | changes |
|---|---|---|
{rows}"""


if __name__ == "__main__":
    sys.exit(main())
