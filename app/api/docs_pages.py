"""The pages of the folder docs/ for a browser, under /docs/: where the "?" of a page leads."""

import html
import re
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Final

from fastapi import HTTPException
from markdown_it import MarkdownIt
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, Response
from starlette.routing import Route, Router

LIST: Final = "README"  # the page that lists all others
TEXT: Final = ".md"
KINDS: Final = {".webp": "image/webp"}  # all others are plain text
NO_PAGE: Final = "There is no page of this name: the list of all pages is at /docs/."


def docs_pages(folder: Path, frame: str) -> Router:
    """Return the application for the pages of a folder; `frame` is the HTML around each, with an empty main."""
    files = {file.relative_to(folder).as_posix(): file for file in folder.rglob("*") if file.is_file()}

    @lru_cache
    def page(name: str) -> str:
        title, content = to_html(files[name].read_text(encoding="utf-8"))
        framed = frame.replace("<title>", f"<title>{html.escape(title)} · ")
        return framed.replace("<main></main>", f"<main>{content}</main>")

    def answer(request: Request) -> Response:
        """Return a page as HTML, or a file that one leads to as it is."""
        name = request.path_params["name"]
        if (text := f"{name or LIST}{TEXT}") in files:
            return HTMLResponse(page(text))
        if name not in files:
            raise HTTPException(404, NO_PAGE)
        return FileResponse(files[name], media_type=KINDS.get(files[name].suffix, "text/plain; charset=utf-8"))

    return Router([Route("/{name:path}", answer)])


def to_html(text: str) -> tuple[str, str]:
    """Return the title and the HTML of a text in Markdown.

    Tags within the text are shown, not obeyed. A heading can be linked to by its words. Links to other pages lose
    their ".md", because the pages here have none.
    """
    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    tokens = reader.parse(text)
    headings = [(tag, words) for tag, words in pairwise(tokens) if tag.type == "heading_open"]
    for tag, words in headings:
        tag.attrSet("id", _anchor(words.content))
    for link in (part for token in tokens for part in token.children or [] if part.type == "link_open"):
        link.attrSet("href", re.sub(r"\.md(?=#|$)", "", str(link.attrGet("href"))))
    title = headings[0][1].content if headings else ""
    return title, str(reader.renderer.render(tokens, reader.options, {}))


def _anchor(words: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", words.lower()).strip("-")
