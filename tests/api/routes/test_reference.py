"""What pages look up, also before anybody has signed in."""

from typing import Any

from app.scoring.measures import TEST_MEASURES, TRIAL_MEASURES


def test_each_measure_is_served_as_the_catalogue_has_it_in_its_order(clinic: Any) -> None:
    measures = clinic.good("GET", "/reference")["measures"]
    assert list(measures["trial"]) == list(TRIAL_MEASURES)
    assert list(measures["test"]) == list(TEST_MEASURES)
    area = measures["trial"]["e_diff"]
    assert (area["name"], area["unit"], area["ucum"], area["digits"]) == ("Area off the path", "m²", "m2", 2)
    assert (area["better"], area["needs_goal"], area["of_whole"], area["of"]) == ("low", True, True, None)
    assert measures["leading"][-1] == {"has": [], "names": ["e_diff", "dist", "time"]}
