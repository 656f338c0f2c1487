"""The words of measures on a report are those on the pages."""

import re

from app.reports.measure_words import MEASURE_WORDS, REACHED_WORDS, with_unit
from app.scoring.learning_words import MEASURES
from app.scoring.verdict.leading_measures import LEADING, leading_measures, leading_of_task
from app.scoring.verdict.measure_verdict import VERDICT_WORDS
from folders import ROOT

TEXTS = ROOT / "web_static" / "js"


def test_every_measure_has_the_words_and_digits_of_the_pages():
    texts = (TEXTS / "texts" / "en" / "measures.js").read_text()
    shown = (TEXTS / "results" / "measures.js").read_text()
    assert set(MEASURE_WORDS) == set(MEASURES)
    assert f'"measure.reached": "{REACHED_WORDS}",' in texts
    for name, words in MEASURE_WORDS.items():
        assert f'"measure.{name}": "{words}",' in texts
        found = re.search(rf'  {name}: {{ unit: "(.*?)", digits: (\d)(?:, factor: (\d+))?', shown)
        assert found
        unit, digits, factor = found.groups("1")
        assert (unit, int(digits), float(factor)) == (MEASURES[name].unit, MEASURES[name].digits, MEASURES[name].factor)


def test_the_verdicts_have_the_words_of_the_pages():
    texts = (TEXTS / "texts" / "en" / "results" / "verdict.js").read_text()
    assert all(f'"verdict.{word}": "{words}",' in texts for word, words in VERDICT_WORDS.items())


def test_measures_stand_in_the_order_of_the_pages():
    shown = (TEXTS / "results" / "measures.js").read_text()
    assert re.findall(r"^  (\w+): \{ unit:", shown, re.MULTILINE) == list(MEASURE_WORDS)
    leading = re.findall(r"\{ has: \[(.*?)\], large: \[(.*?)\] \}", shown)
    assert [tuple(tuple(re.findall(r'"(\w+)"', names)) for names in row) for row in leading] == list(LEADING)


def test_the_measures_of_a_task_are_chosen_by_what_it_has():
    trial = {"e_diff": 1, "dist": 2, "time": 3, "sparc": -4, "collisions": 0}
    assert leading_measures(trial) == ("e_diff", "dist", "time")
    turn = {"heading_error_deg": 3, "turn_drift": 0.1, "time": 9, "collisions": 1}
    assert leading_measures(turn) == ("heading_error_deg", "turn_drift", "time")
    assert leading_measures({"sparc": -4, "mean_speed": 0.3}) == ("sparc",)
    assert leading_measures({}) == ()
    missed = {"gaps": 2, "gap_clearance": None, "e_diff": 1, "time": 3}
    assert leading_of_task([missed, missed | {"gap_clearance": 0.1}]) == ("gap_clearance", "e_diff", "time")


def test_levels_have_their_unit():
    assert with_unit("e_diff", 1.234) == "1.23 m²"
    assert with_unit("heading_error_deg", 12.0) == "12°"
    assert with_unit("sparc", -3.5) == "\u22123.50"
    assert with_unit("heading_error_deg", 12.3) == "12°"
    assert with_unit("follow_near", 0.434) == "43 %"
    assert with_unit("collisions", 0.4) == "0.4"
    assert with_unit("dist", None) == ""
