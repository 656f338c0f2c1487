"""The language of a request is the reader's choice, then the browser's, then English."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import HTTPConnection

from app.api.request_language import RequestLanguage, language_of
from app.texts import LANGUAGES, current_language
from event_loop import in_event_loop


def request(query="", **headers):
    sent = [(name.replace("_", "-").encode(), value.encode("latin-1")) for name, value in headers.items()]
    asked = {"type": "http", "scheme": "http", "method": "GET", "path": "/"}
    return asked | {"query_string": query.encode(), "headers": sent}


@pytest.mark.parametrize(
    ("headers", "language"),
    [
        ({}, "en"),
        ({"accept_language": "de-AT,de;q=0.9,en;q=0.8"}, "de"),
        ({"accept_language": "xx-XX, es;q=0.4, de;q=0.7"}, "de"),
        ({"accept_language": "xx"}, "en"),
        ({"accept_language": "de;q=much, es"}, "es"),
        ({"accept_language": "de", "cookie": "language=es"}, "es"),
        ({"accept_language": "de", "cookie": "language=xx; other=es"}, "de"),
        ({"query": "language=es", "cookie": "language=de"}, "es"),
        ({"query": "language=xx", "cookie": "language=de"}, "de"),
    ],
)
def test_the_choice_counts_before_what_the_browser_asks_for(headers, language):
    assert language_of(HTTPConnection(request(**headers))) == language


@given(st.text(st.characters(max_codepoint=255)))
def test_no_header_is_an_error(header):
    assert language_of(HTTPConnection(request(accept_language=header))) in LANGUAGES


@in_event_loop
async def test_an_answer_is_made_in_the_language_of_its_request():
    async def app(scope, receive, send):
        seen.append(current_language())

    seen = []
    await RequestLanguage(app)(request(cookie="language=de"), None, None)
    assert (seen, current_language()) == (["de"], "en")
