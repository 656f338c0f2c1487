"""A reader chooses a language once: it is the browser's, and follows the person to other browsers."""

from api.fake_clinic import Clinic, sentence_of
from pseudo_language import PSEUDO

from app.texts import LANGUAGES, Text


def test_the_choice_is_of_the_browser_and_of_the_person(owned: Clinic) -> None:
    assert owned.good("GET", "/auth/me")["language"] == "en"
    assert owned("PUT", "/auth/language", json={"language": "de"}).status_code == 204
    assert owned.good("GET", "/auth/me")["language"] == "de"
    owned.client.cookies.delete("language")
    assert owned.good("GET", "/auth/me")["language"] == "de"
    owned("POST", "/auth/sign-out")
    assert owned.good("GET", "/auth/me")["language"] == "en"


def test_before_the_sign_in_it_is_of_the_browser_alone(owned: Clinic) -> None:
    owned("POST", "/auth/sign-out")
    assert owned("PUT", "/auth/language", json={"language": "es"}).status_code == 204
    assert owned.good("GET", "/auth/me")["language"] == "es"


def test_a_language_that_is_not_offered_is_refused(owned: Clinic) -> None:
    answer = owned("PUT", "/auth/language", json={"language": PSEUDO})
    assert sentence_of(answer, 422) == str(Text("language-not-offered", language=PSEUDO, languages=LANGUAGES))
