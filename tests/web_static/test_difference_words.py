"""The sentences of the differences of two parameter sets; the module runs in node, without a page."""

import json

import pytest
from session.test_parameter_differences import STANDARD, changed, gesture

from app.session.parameter_differences import differences
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from small_profile import small_profile

CASES = [
    (changed(title="Gentle"), "The set's name: “Standard” → “Gentle”."),
    (changed(mode_u1="velocity"), "Forward and back: keeps its speed → follows the movement."),
    (changed(mode_u2="acceleration"), "Turning: follows the movement → keeps turning."),
    (changed(cutoff=4.0), "Tremor damping: 3.0 → 4.0 Hz."),
    (changed(cutoff=3.001), "Tremor damping: 3.000 → 3.001 Hz."),
    (changed(cruise_time=8.0), "Stops by itself after: 10 → 8 s."),
    (changed(turn_cruise_time=2.5), "Stops turning by itself after: 3.0 → 2.5 s."),
    (changed(speeds=Speeds(forward=0.6)), "Forward speed: 0.80 → 0.60 m/s."),
    (changed(speeds=Speeds(turn=0.6)), "Turn speed: 69 → 34 °/s."),
    (gesture(dead_zone=0.25), "right_elbow counts from: 20 → 25 % / s."),
    (gesture(full=1.2), "right_elbow full at: 100 → 120 % / s."),
    (gesture(feature="displacement"), "right_elbow: moving → holding."),
    (gesture(direction=-1), "right_elbow, going back: now counts in the other direction."),
    (changed(bindings=()), "Faster: right_elbow, gain 1 → nothing."),
    (changed(profile=small_profile(("right_elbow", "left_elbow", "left_wrist"))), "The calibration is another one."),
    (changed(gestures=STANDARD.gestures[1:]), "right_elbow: no longer used."),
    (
        changed(gestures=tuple(reversed(STANDARD.gestures))),
        "The movements and numbers are the same, but saved in another order.",
    ),
]
EVERY_SPEED = [changed(speeds=Speeds(**{name: getattr(HIGHEST_SPEEDS, name)})) for name in Speeds.model_fields]


@pytest.fixture(scope="module")
def words(run_script, tmp_path_factory):
    """Return, for each set of both lists, the sentences that the page shows."""
    sets = [now for now, _ in CASES] + EVERY_SPEED
    documents = [[one.model_dump(mode="json") for one in differences(now, STANDARD)] for now in sets]
    file = tmp_path_factory.mktemp("words") / "differences.json"
    file.write_text(json.dumps(documents), encoding="utf-8")
    return json.loads(run_script("difference_words.mjs", file))


@pytest.mark.parametrize(("number", "sentence"), list(enumerate(sentence for _, sentence in CASES)))
def test_each_difference_has_its_sentence(words, number, sentence):
    assert sentence in words[number]


def test_every_speed_has_its_words_and_every_sentence_its_end(words):
    for sentences in words[len(CASES) :]:
        assert len(sentences) == 1
    sentences = [sentence for one in words for sentence in one]
    assert all(sentence.endswith(".") for sentence in sentences)
    assert not any("{" in sentence or "differs-" in sentence or "speed-" in sentence for sentence in sentences)
