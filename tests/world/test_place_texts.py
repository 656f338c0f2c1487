"""The texts of the bundled places: each has its message, whose English is that of the document."""

import json
from collections.abc import Iterator
from typing import Any

import pytest

from app.texts import LANGUAGES, Text, reader_language
from app.world.floorplan import LINES_ARE_FREE, FloorPlan, bundled_floorplans
from app.world.place_texts import messages_in, place_text, plan_for_reader
from app.world.scene import bundled_places, bundled_scenes
from words import WORDS, messages_of

PLACES = bundled_places()
FILES = {**bundled_floorplans(), **bundled_scenes()}
SHAPES = {"obstacles", "gaps"}  # their labels choose shapes, or are seen in the editor only: they stay English


def texts_of(value: Any) -> Iterator[str]:
    """Yield what people read of a document: titles, instructions, what a scene says about itself, labels of rooms."""
    if isinstance(value, list):
        for item in value:
            yield from texts_of(item)
    elif isinstance(value, dict):
        for name, inner in value.items():
            if name in {"title", "instruction", "about", "label"}:
                yield from inner.values() if isinstance(inner, dict) else [inner]
            elif name not in SHAPES:
                yield from texts_of(inner)


@pytest.mark.parametrize("document", FILES)
def test_each_text_of_a_bundled_document_has_a_message(document):
    texts = set(texts_of(json.loads(FILES[document].read_bytes())))
    places = [place for name, place in PLACES.items() if name.partition(".")[0] == document]
    assert len(texts) > 4
    assert texts - {text for place in places for text, _ in messages_in(place)} == set()


def test_the_english_of_a_message_is_the_text_of_the_document():
    for name, place in PLACES.items():
        assert [str(message) for _, message in messages_in(place)] == [text for text, _ in messages_in(place)], name
        assert plan_for_reader(place.plan) == place.plan, name


def test_each_message_is_that_of_a_text():
    used = {message.id for place in PLACES.values() for _, message in messages_in(place)}
    assert set(messages_of(WORDS / "en" / "server" / "places.ftl")) == used


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_places_in_a_language_are_floor_plans(language):
    """A text is short enough for its field, and one English text of a place has one translation."""
    for name, place in PLACES.items():
        with reader_language(language):
            shown = plan_for_reader(place.plan)
            words = {(text, str(message)) for text, message in messages_in(place)}
        FloorPlan.model_validate_json(shown.model_dump_json(), context=LINES_ARE_FREE)
        assert len(words) == len(dict(words)), name


def test_a_bundled_place_is_shown_in_the_language_of_the_reader():
    with reader_language("de"):
        clinic, course = (plan_for_reader(PLACES[name].plan) for name in ("clinic", "skills.hard"))
        assert str(place_text("desert.hard", "Desert, hard")) == "Wüste, schwer"
    assert (clinic.title, clinic.rooms[0].label) == ("Klinikstockwerk", "Therapie")
    assert clinic.paths[0].instruction.startswith("Folgen Sie der weißen Linie")
    assert clinic.obstacles == PLACES["clinic"].plan.obstacles
    assert course.paths[0].task.stages[0].title == "10 m geradeaus"
    assert course.paths[0].points == PLACES["skills.hard"].plan.paths[0].points


@pytest.mark.parametrize(
    ("plan", "text"),
    [
        ("clinic", "Our clinic"),  # a document that was changed
        ("clinic-2", "Clinic storey"),  # a copy that the clinic drew further
        ("desert", "Desert"),  # a scene, but no floor plan
        ("../clinic", "Clinic storey"),
        ("", ""),
    ],
)
def test_a_text_of_another_plan_stays_as_it_is(plan, text):
    assert place_text(plan, text) == text


def test_a_bundled_text_is_kept_as_its_message():
    assert place_text("clinic", "Clinic storey") == Text("place-clinic-title")
