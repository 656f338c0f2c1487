"""`python -m bench.compare COMMIT`: runs the benchmark of another commit and of this tree in turn, and compares them.

Both run on this machine in the same minutes, so that what else the machine does meets both alike.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from statistics import median

from bench.children import ROOT

RUNS = 5
Figures = dict[str, list[float]]
"""Every figure of a row, by the row's name."""


def main() -> None:
    """Measure parts of the benchmark in another commit and in this tree, in turn."""
    parser = argparse.ArgumentParser(prog="python -m bench.compare", description=main.__doc__)
    parser.add_argument("commit", help="What to compare with: a commit, a branch or a tag.")
    parser.add_argument("parts", nargs="*", metavar="PART", help="Parts of the benchmark; all of it when left out.")
    parser.add_argument("--runs", type=int, default=RUNS, help="How often each is measured.")
    given = parser.parse_args()
    if given.runs < 1:
        parser.error("--runs must be 1 or more")
    try:
        with checkout(given.commit) as other:
            found = measure_in_turn(other, given.parts, given.runs)
    except subprocess.CalledProcessError as error:
        sys.exit(f"The commits cannot be compared: {error.stderr.decode().strip()}")
    except RuntimeError as error:
        sys.exit(f"The commits cannot be compared: {error}")
    sys.stdout.write(table(*found))


@contextmanager
def checkout(commit: str) -> Iterator[Path]:
    """Yield a folder with the files of a commit."""
    with tempfile.TemporaryDirectory(prefix="bodydrive-compare-") as folder:
        files = subprocess.run(["git", "archive", commit], cwd=ROOT, check=True, capture_output=True).stdout
        subprocess.run(["tar", "--extract", "--directory", folder], input=files, check=True, capture_output=True)
        yield Path(folder)


def measure_in_turn(other: Path, parts: Sequence[str], runs: int) -> tuple[Figures, Figures]:
    """Return the figures of the other tree and of this one, measured in turn."""
    figures: tuple[Figures, Figures] = (defaultdict(list), defaultdict(list))
    for _ in range(runs):
        for tree, of_tree in zip((other, ROOT), figures, strict=True):
            for name, figure in measure(tree, parts).items():
                of_tree[name].append(figure)
    return figures


def measure(tree: Path, parts: Sequence[str]) -> dict[str, float]:
    """Return the figures of one run in a tree, by the names of their rows."""
    if not (tree / "bench" / "__main__.py").is_file():
        raise RuntimeError("that commit is older than the benchmark and has none of its own, so name a newer commit")
    environment = {**os.environ, "PYTHONPATH": str(tree)}
    command = [sys.executable, "-m", "bench", *parts, "--json"]
    ended = subprocess.run(command, cwd=tree, env=environment, check=False, capture_output=True, text=True)
    if ended.returncode:
        raise RuntimeError(f"{tree}: the benchmark ended with\n{ended.stderr.strip()}")
    return {row["what"]: row["figure"] for row in json.loads(ended.stdout)["rows"]}


def table(before: Figures, now: Figures) -> str:
    """Return a Markdown table of the rows that both trees have: medians with their spread, and their ratio."""
    lines = ["| what | before | now | now / before |", "|---|---|---|---|"]
    for what in (name for name in now if name in before):
        ratio = median(now[what]) / median(before[what])
        lines.append(f"| {what} | {_spread(before[what])} | {_spread(now[what])} | {ratio:.2f} |")
    return "\n".join(lines) + "\n"


def _spread(figures: Sequence[float]) -> str:
    return f"{median(figures):.3g} ({min(figures):.3g} to {max(figures):.3g})"


if __name__ == "__main__":
    main()
