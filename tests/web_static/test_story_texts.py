"""Each kind of event in a session's story has its text; without one, the page would show the key."""

import re
from typing import get_args

from app.features.registration import EventKind
from folders import ROOT

TEXTS = ROOT / "web_static" / "js" / "texts" / "en" / "sharing" / "share.js"


def test_each_kind_of_event_has_its_text() -> None:
    found = set(re.findall(r'"share\.event\.([\w-]+)":', TEXTS.read_text(encoding="utf-8")))
    assert found == set(get_args(EventKind))
