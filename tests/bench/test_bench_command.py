"""`python -m bench`, as `make bench` runs it."""

import json
import subprocess
import sys

from folders import ROOT


def bench(*words):
    return subprocess.run(
        [sys.executable, "-m", "bench", *words], check=False, capture_output=True, text=True, cwd=ROOT
    )


def test_one_part_is_measured_and_printed_as_one_json_object():
    ended = bench("fit", "--json")
    assert ended.returncode == 0, ended.stderr
    found = json.loads(ended.stdout)
    assert found["machine"]
    assert [row["figure"] > 0 for row in found["rows"]] == [True]


def test_an_unknown_part_is_refused_in_one_sentence():
    ended = bench("fit", "speed")
    assert ended.returncode == 2
    assert "there is no part 'speed' to measure: use any of chain, gate" in ended.stderr
