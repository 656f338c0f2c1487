"""The files of the pages: read once, compressed, and kept by a browser under an address that names their version.

The pages of the folder docs/ stand under /docs/, where the "?" of a page leads.
"""

import gzip
import html
import json
import posixpath
import re
from collections import defaultdict
from collections.abc import Iterable
from functools import lru_cache
from hashlib import sha256
from itertools import pairwise
from pathlib import Path
from typing import Final, NamedTuple

from fastapi import HTTPException
from fastapi.concurrency import run_in_threadpool
from markdown_it import MarkdownIt
from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, Response
from starlette.routing import Route, Router
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.websockets import WebSocketClose

from app import __version__

KINDS: Final = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".webmanifest": "application/manifest+json",
}
FIRST: Final = {"index.html": ["js/pages/drive/drive.js"]}  # modules that an entry imports as soon as it has started
LARGE: Final = 200_000  # bytes: such a script is compressed when a page first asks for it, not at the start
FOR_EVER: Final = "public, max-age=31536000, immutable"
ASK_AGAIN: Final = "no-cache"  # a browser asks each time whether its copy is still good

WORDS: Final = "words"  # the folder of the messages in Fluent: words/LANGUAGE/*.ftl
LANGUAGES: Final = ("en",)  # that the pages offer
ALONE: Final = frozenset({"help", "tablet"})  # files of messages that are loaded only where they are shown
SHARED: Final = "pages"  # the module with the messages of all other files

DOCS_LIST: Final = "README"  # of docs/, the page that lists all others
MARKDOWN: Final = ".md"
DOCS_KINDS: Final = {".webp": "image/webp"}  # of files beside the pages; all others are plain text
NO_DOCS_PAGE: Final = "There is no page of this name: the list of all pages is at /docs/."

VERSION: Final = re.compile(r"v-([0-9a-f]+)/")
LINK: Final = re.compile(r'(href|src)="([a-z][^":]+)"')
STYLE: Final = re.compile(r'<link rel="stylesheet" href="([^"]+)">')
STYLES: Final = re.compile(r'(?:^ *<link rel="stylesheet" href="[^"]+">\n)+', re.MULTILINE)
ENTRY: Final = re.compile(r' *<script type="module" src="([^"]+)"></script>\n')
BEGINNING: Final = '  <script type="module" src="js/first_picture.js"></script>\n'  # adds the program to the page
PROGRAM: Final = '  <template id="program">\n{}  </template>\n</body>'
IMPORT: Final = re.compile(r"""^(?:import|export)(?:[^"';]*\bfrom)? *["'](\.{1,2}/[^"']+)["']""", re.MULTILINE)


class PageFile(NamedTuple):
    """One file."""

    kind: str  # Content-Type
    content: bytes
    compressed: bytes  # in gzip


class Pages:
    """ASGI application that answers with the files of a folder.

    An entry (an HTML file) names its styles, joined to one file, and its script under `/v-VERSION/`, and the modules
    that this imports in turn, so that a browser loads all of them at once and keeps them until the version changes.
    Under any other address, also that of an earlier version, a file is the present one, and a browser asks again each
    time.
    """

    def __init__(self, folder: Path) -> None:
        files = sorted(file for file in folder.rglob("*") if file.suffix in KINDS)
        contents = {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}
        contents |= word_modules(folder)
        digest = sha256(__version__.encode())
        for name, content in contents.items():
            digest.update(f"{name} {len(content)} ".encode() + content)
        self.version = digest.hexdigest()[:16]
        for name in [name for name in contents if name.endswith(".html")]:
            text = contents[name].decode()
            styles = f"{name.removesuffix('.html')}.css"
            contents[styles] = b"".join(contents[style] for style in STYLE.findall(text))
            contents[name] = self._entry(text, styles, _needed([*ENTRY.findall(text), *FIRST.get(name, [])], contents))
        self._large = {name: contents.pop(name) for name in list(contents) if len(contents[name]) > LARGE}
        self._files = {name: _page_file(name, content) for name, content in contents.items()}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request for a file."""
        if scope["type"] == "websocket":
            await WebSocketClose()(scope, receive, send)
            return
        if scope["method"] not in {"GET", "HEAD"}:
            raise HTTPException(405)
        name, version = _name_and_version(scope["path"])
        file = await self._file(name)
        await self._answer(file, Headers(scope=scope), is_present=version == self.version)(scope, receive, send)

    def is_asked_for(self, scope: Scope) -> bool:
        """Return whether a request is for a file under the address of a version."""
        if scope["type"] != "http" or scope["method"] != "GET":
            return False
        name, version = _name_and_version(scope["path"])
        return version is not None and name in self._files

    def text(self, name: str) -> str:
        """Return a file as it is sent."""
        return self._files[name].content.decode()

    async def _file(self, name: str) -> PageFile:
        if name in self._large and name not in self._files:
            self._files[name] = await run_in_threadpool(_page_file, name, self._large[name])
        if name not in self._files:
            raise HTTPException(404)
        return self._files[name]

    def _answer(self, file: PageFile, asked: Headers, *, is_present: bool) -> Response:
        tag = f'W/"{self.version}"'
        headers = {
            "Cache-Control": FOR_EVER if is_present else ASK_AGAIN,
            "Content-Type": file.kind,
            "ETag": tag,
            "Vary": "Accept-Encoding",
        }
        if asked.get("if-none-match") == tag:
            return Response(status_code=304, headers=headers)
        if "gzip" not in asked.get("accept-encoding", ""):
            return Response(file.content, headers=headers)
        return Response(file.compressed, headers={**headers, "Content-Encoding": "gzip"})

    def _entry(self, text: str, styles: str, modules: list[str]) -> bytes:
        """Return an entry with one link to its joined styles, all addresses of this version.

        Its script, with links to the modules, stands in a template: the browser draws the entry's own words first.
        """
        preloads = "".join(f'  <link rel="modulepreload" href="{module}">\n' for module in modules)
        scripts = "".join(match[0] for match in ENTRY.finditer(text))
        joined = STYLES.sub(f'  <link rel="stylesheet" href="{styles}">\n', text)
        joined = ENTRY.sub(BEGINNING, joined).replace("</body>", PROGRAM.format(preloads + scripts))
        return LINK.sub(rf'\1="/v-{self.version}/\2"', joined).encode()


def _name_and_version(path: str) -> tuple[str, str | None]:
    """Return the name of the file at a path, and the version that the path names, None for none."""
    name = path.lstrip("/") or "index.html"
    version = VERSION.match(name)
    return (name[version.end() :], version[1]) if version else (name, None)


class PagesFirst:
    """Middleware that answers for the files of a version at once.

    A page asks for more than a hundred of them, and to look through all routes first takes longer than the answer.
    """

    def __init__(self, app: ASGIApp, pages: Pages) -> None:
        self._app = app
        self._pages = pages

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request for such a file, and pass on any other."""
        app = self._pages if self._pages.is_asked_for(scope) else self._app
        await app(scope, receive, send)


def read_entry(folder: Path, entry: str) -> dict[str, PageFile]:
    """Return an entry (an HTML file) and the files that it needs, by their names, as they are."""
    text = (folder / entry).read_text()
    styles = [name for kind, name in LINK.findall(text) if kind == "href"]
    words, scripts = word_modules(folder), dict[str, bytes]()
    waiting = ENTRY.findall(text)
    while waiting:
        name = waiting.pop()
        if name not in scripts:
            scripts[name] = words[name] if name in words else (folder / name).read_bytes()
            waiting += _imported(name, scripts[name])
    contents = {entry: text.encode()} | {name: (folder / name).read_bytes() for name in styles} | scripts
    return {name: _page_file(name, content) for name, content in contents.items()}


def word_modules(folder: Path) -> dict[str, bytes]:
    """Return the modules with the messages of the pages, by their names (`words/en/pages.ftl.js`).

    Each exports messages as one text, without the comments that are for translators. As a module they are imported,
    have the pages' version and are loaded at once with the others, as nothing else would be.
    """
    parts: dict[str, list[str]] = defaultdict(list)
    for language in LANGUAGES:
        for file in sorted((folder / WORDS / language).glob("*.ftl")):
            module = file.stem if file.stem in ALONE else SHARED
            lines = file.read_text(encoding="utf-8").splitlines()
            parts[f"{WORDS}/{language}/{module}.ftl.js"] += [line for line in lines if not line.startswith("#")]
    texts = {name: json.dumps("\n".join(lines), ensure_ascii=False) for name, lines in parts.items()}
    return {name: f"export default {text};\n".encode() for name, text in texts.items()}


def _page_file(name: str, content: bytes) -> PageFile:
    return PageFile(KINDS[posixpath.splitext(name)[1]], content, gzip.compress(content, mtime=0))


def _needed(names: Iterable[str], contents: dict[str, bytes]) -> list[str]:
    """Return the modules, and all modules that they import, in the order of their imports."""
    needed: dict[str, None] = {}
    waiting = list(names)[::-1]
    while waiting:
        name = waiting.pop()
        if name in needed:
            continue
        needed[name] = None
        waiting += reversed(_imported(name, contents[name]))
    return list(needed)


def _imported(name: str, script: bytes) -> list[str]:
    """Return the names of the modules that a module imports."""
    imported = IMPORT.findall(script.decode())
    return [posixpath.normpath(posixpath.join(posixpath.dirname(name), path)) for path in imported]


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
        if (text := f"{name or DOCS_LIST}{MARKDOWN}") in files:
            return HTMLResponse(page(text))
        if name not in files:
            raise HTTPException(404, NO_DOCS_PAGE)
        return FileResponse(files[name], media_type=DOCS_KINDS.get(files[name].suffix, "text/plain; charset=utf-8"))

    return Router([Route("/{name:path}", answer)])


def to_html(text: str) -> tuple[str, str]:
    """Return the title and the HTML of a text in Markdown.

    Tags within the text are shown, not obeyed. A heading can be linked to by its words. Links to other pages lose
    their ".md", because the pages here have none.
    """
    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    tokens = reader.parse(text)
    headings = [(tag, text_token) for tag, text_token in pairwise(tokens) if tag.type == "heading_open"]
    for tag, text_token in headings:
        tag.attrSet("id", _anchor(text_token.content))
    for link in (part for token in tokens for part in token.children or [] if part.type == "link_open"):
        link.attrSet("href", re.sub(r"\.md(?=#|$)", "", str(link.attrGet("href"))))
    title = headings[0][1].content if headings else ""
    return title, str(reader.renderer.render(tokens, reader.options, {}))


def _anchor(heading: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")
