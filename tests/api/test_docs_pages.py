"""The pages of docs/ in the browser: each answers, each link on one leads somewhere, and the list names all."""

import re
from functools import cache
from html.parser import HTMLParser
from typing import Any
from urllib.parse import urldefrag, urljoin, urlsplit

from app.api.pages import to_html
from app.faults import EXPLANATIONS, Fault
from folders import ROOT

DOCS = ROOT / "docs"
PAGES = sorted(file.relative_to(DOCS).as_posix().removesuffix(".md") for file in DOCS.rglob("*.md"))


class Links(HTMLParser):
    """The addresses on a page, and the places on it that can be linked to."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.to: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        self.to += [given[name] or "" for name in ("href", "src") if tag in {"a", "img"} and name in given]
        self.places |= {given["id"] or ""} if "id" in given else set()


def test_each_link_and_picture_of_a_page_leads_somewhere(clinic: Any) -> None:
    @cache
    def links_of(address: str) -> Links | None:
        answer = clinic.client.get(address)
        return Links(answer.text) if answer.status_code == 200 else None

    for name in PAGES:
        here = f"/docs/{name}"
        page = links_of(here)
        assert page is not None, here
        for link in page.to:
            if not urlsplit(link).scheme:
                address, place = urldefrag(urljoin(here, link))
                found = links_of(address)
                assert found is not None, (here, link)
                assert not place or place in found.places, (here, link)


def test_the_list_names_every_page(clinic: Any) -> None:
    linked = {
        urljoin(f"/docs/{page}", link)
        for page in ("", "decisions/README")
        for link in Links(clinic.client.get(f"/docs/{page}").text).to
    }
    assert {f"/docs/{name}" for name in PAGES if name != "README"} <= linked


def test_a_page_has_its_title_the_frame_and_our_policy(clinic: Any) -> None:
    answer = clinic.client.get("/docs/clinicians")
    assert "<title>For clinicians · bodydrive</title>" in answer.text
    assert 'href="/docs/"' in answer.text
    assert "default-src 'none'" in answer.headers["Content-Security-Policy"]


def test_pictures_have_their_types(clinic: Any) -> None:
    for name, kind in (("wired-shirt.svg", "image/svg+xml"), ("shirt.webp", "image/webp")):
        assert clinic.client.get(f"/docs/pictures/{name}").headers["Content-Type"] == kind


def test_nothing_outside_of_the_folder_is_a_page(clinic: Any) -> None:
    for name in ("../pyproject", "%2e%2e/README", "..%2fREADME", "nobody", "README.md/", "pictures/"):
        assert clinic.client.get(f"/docs/{name}", follow_redirects=False).status_code == 404, name


def test_tags_in_a_text_are_shown_and_not_obeyed() -> None:
    title, shown = to_html("# A & B\n\n<script>alert(1)</script> [x](javascript:alert(1)) [y](safety.md#what-holds)\n")
    assert title == "A & B"
    assert "<script" not in shown
    assert 'href="javascript' not in shown
    assert 'href="safety#what-holds"' in shown


def test_the_clinicians_page_explains_every_stop_in_the_words_of_the_screen() -> None:
    text = re.sub(r"\s+", " ", (DOCS / "clinicians.md").read_text(encoding="utf-8"))
    for fault in Fault:
        assert fault is Fault.NONE or str(EXPLANATIONS[fault].happened) in text, fault
