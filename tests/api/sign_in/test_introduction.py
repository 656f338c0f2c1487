"""The sentences for a first time: put away once, they stay away for this person, whatever the browser."""

from api.fake_clinic import Clinic
from api.people_of_clinic import accepted, invited


def test_what_one_person_put_away_stays_away_for_this_person_only(owned: Clinic) -> None:
    ben = accepted(owned, invited(owned, "Ben", "reviewer"))
    assert owned.good("GET", "/start")["me"]["introduced"] is False
    assert owned("POST", "/auth/introduction").status_code == 204
    assert owned.good("GET", "/start")["me"]["introduced"] is True
    with owned.as_person(ben):
        assert owned.good("GET", "/auth/me")["introduced"] is False
    owned("POST", "/auth/sign-out")
    assert owned.good("GET", "/auth/me")["introduced"] is False  # nobody is signed in
