"""`equal_drives.py FOLDER`: compares the drives of the compiled program in FOLDER with those of plain Python."""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
LEAST_PERMITTED = 0.1  # of the time, over all drives: a comparison of chairs that stand would show little


def drives(program):
    """Return what `many_drives.py` prints with the program in this folder."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(program), str(ROOT / "tests")])}
    words = [sys.executable, str(Path(__file__).with_name("many_drives.py"))]
    return json.loads(subprocess.run(words, env=environment, check=True, stdout=subprocess.PIPE).stdout)


def main():
    compiled, pure = drives(Path(sys.argv[1]).resolve()), drives(ROOT)
    if not compiled["compiled"] or pure["compiled"]:
        sys.exit(f"{sys.argv[1]} has to hold the compiled program, and {ROOT} plain Python")
    for kind in ("drives", "studies"):
        pairs = enumerate(zip(compiled[kind], pure[kind], strict=True))
        differing = [i for i, (one, other) in pairs if one != other]
        if differing:
            sys.exit(f"compiled and plain Python differ in the {kind} {differing}")
    permitted = sum(share for _, _, share in pure["drives"]) / len(pure["drives"])
    if permitted < LEAST_PERMITTED:
        sys.exit(f"motion was permitted for only {permitted:.0%} of the time: the drives compare too little")
    count, studies = len(pure["drives"]), len(pure["studies"])
    sys.stdout.write(f"{count} drives (motion was permitted {permitted:.0%}) and {studies} studies are equal\n")


if __name__ == "__main__":
    main()
