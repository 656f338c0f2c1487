"""Each kind of event in a session's story has its text; without one, the page would show the id."""

from typing import get_args

from web_static.messages import WORDS, id_of, ids_of

from app.features.registration import EventKind


def test_each_kind_of_event_has_its_text() -> None:
    found = {name for name in ids_of(WORDS / "en" / "share.ftl") if name.startswith("share-event-")}
    assert found == {f"share-event-{id_of(kind)}" for kind in get_args(EventKind)}
