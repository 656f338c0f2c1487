"""Small files as other programs write them, each with the plan that is right for it."""

import pytest

from app.world.imports.draft import plan_of
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan
from folders import SHARED

CASES = SHARED / "data" / "cases"


def imported(name):
    file = CASES / name
    if not file.exists():
        pytest.skip("the small files of other programs are not beside this checkout")
    draft = import_plan(file, Options())
    return draft, plan_of(draft, name)


@pytest.mark.parametrize(
    "name", ["control", "unknown-free-025", "raw", "alpha", "thresholds-0-1", "absolute-path", "exponent"]
)
def test_the_flat_is_the_plan_in_each_form_of_a_map(name):
    draft, plan = imported(f"map-{name}.yaml")
    assert plan.bounds == pytest.approx((5, 5, 13, 10), abs=0.11)
    assert plan.paths[0].line.length == pytest.approx(9.0, abs=0.3)
    assert "8.0 x 5.0 m large" in draft.words[1]
    assert "unknown" in draft.words[2]


def test_a_small_flat_has_a_way():
    _, plan = imported("map-small-flat.yaml")
    assert plan.paths[0].line.length >= 6


def test_a_noisy_scan_is_made_simpler_and_says_so():
    draft, plan = imported("map-noisy-scan.yaml")
    assert len(plan.segments()) < 5000
    area = float(draft.words[1].partition("with ")[2].split(" ")[0])
    assert area == pytest.approx(137, abs=6)
    assert any("too many wall pieces" in words for words in draft.words)


@pytest.mark.parametrize("name", ["open", "closed"])
def test_an_open_entrance_changes_nothing(name):
    _, plan = imported(f"dxf-entrance-{name}.dxf")
    assert plan.paths[0].line.length == pytest.approx(11.3, abs=0.3)
