"""What people are told of each kind of shirt before they choose it: the page and docs/hardware.md say the same."""

import pytest

from app.api.routes.equipment import shirt_kind_view
from app.hardware.configs import KINDS
from app.hardware.shirt.kind import Trust
from folders import ROOT

PAGE = (ROOT / "docs" / "hardware.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_the_page_of_the_hardware_says_what_the_cards_say(kind):
    view = shirt_kind_view(kind)
    facts = view.form["facts"]
    cells = (view.form["title"], facts["needs"], facts["costs"], facts["takes"], str(view.may_arm))
    assert f"| {' | '.join(cells)} |" in PAGE


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_what_never_arms_a_real_chair_says_so_before_it_is_chosen(kind):
    """Safety S29."""
    assert str(kind.may_arm).startswith("Never") == (kind.trust is Trust.NEVER)
    if kind.name in {"camera", "phones", "slimevr", "bluetooth", "brainflow", "lsl"}:
        assert str(kind.may_arm) == "Never drives a real chair, for nothing proves whose movements it shows."
