"""The files of the pages: read once, compressed, kept by a browser under an address that names version and language.

The pages of the folder docs/ stand under /docs/, where the "?" of a page leads.
"""

import gzip
import html
import json
import posixpath
import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
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
from app.api.response_headers import READER_POLICY
from app.texts import ENGLISH, LANGUAGES, Text, current_language

KINDS: Final = {
    ".css": "text/css; charset=utf-8",
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".webmanifest": "application/manifest+json",
}
LARGE: Final = {  # files of megabytes, which are read when they are asked for
    ".binarypb": "application/octet-stream",
    ".data": "application/octet-stream",
    ".tflite": "application/octet-stream",
    ".wasm": "application/wasm",
}
# What reads a camera's pictures, in a worker or in a frame of its own.
PICTURE_READERS: Final = frozenset({"js/camera/pose_engine.js", "camera.html"})
FIRST: Final = {"index.html": ["js/pages/drive/drive.js"]}  # modules that an entry imports as soon as it has started
FOR_EVER: Final = "public, max-age=31536000, immutable"
ASK_AGAIN: Final = "no-cache"  # a browser asks each time whether its copy is still good

WORDS: Final = "words"  # the folder of the messages in Fluent: words/LANGUAGE/*.ftl
IN_ENTRIES: Final = "entries"  # the file of messages that stand in entries; each of them is one line
ALONE: Final = frozenset({"help", "tablet"})  # files of messages that are loaded only where they are shown
SHARED: Final = "pages"  # the module with the messages of all other files
LANGUAGE_MODULE: Final = "js/language.js"  # says the language of the pages

DOCS_LIST: Final = "README"  # of docs/, the page that lists all others
MARKDOWN: Final = ".md"
DOCS_KINDS: Final = {".svg": "image/svg+xml", ".webp": "image/webp"}  # of other files; all others are plain text
NO_DOCS_PAGE: Final = Text("refused-no-docs-page")

VERSION: Final = re.compile(r"v-([0-9a-f]+)-([A-Za-z-]+)/")
MESSAGE: Final = re.compile(r"^([a-z][\w-]*) = (.+)$", re.MULTILINE)
IN_ENTRY: Final = re.compile(r"\{ ([a-z][\w-]*) \}")  # stands for a message, or for the language
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


class PageFiles:
    """Files by their names, each compressed at once or when it is first asked for."""

    def __init__(self, contents: dict[str, bytes], *, is_at_once: bool) -> None:
        self._contents = contents
        self._files = {name: _page_file(name, content) for name, content in contents.items() if is_at_once}

    def __contains__(self, name: str) -> bool:
        return name in self._contents

    def text(self, name: str) -> str:
        """Return a file as it is sent."""
        return self._contents[name].decode()

    async def file(self, name: str) -> PageFile:
        """Return a file."""
        if name not in self._files:
            self._files[name] = await run_in_threadpool(_page_file, name, self._contents[name])
        return self._files[name]


class Pages:
    """ASGI application that answers with the files of a folder, in one of the languages.

    An entry (an HTML file) is in the language of the request. It names its styles, joined to one file, and its script
    under `/v-VERSION-LANGUAGE/`, and the modules that this imports in turn, so that a browser loads all of them at once
    and keeps them until the version changes. Under any other address, also that of an earlier version, a file is the
    present one, and a browser asks again each time.
    """

    def __init__(self, folder: Path, languages: Sequence[str] = LANGUAGES) -> None:
        files = sorted(file for file in folder.rglob("*") if file.suffix in KINDS)
        shared = {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}
        entries = {name: shared.pop(name).decode() for name in list(shared) if name.endswith(".html")}
        by_language = {language: language_files(folder, language) for language in languages}
        words = {language: _entry_words(folder, language) for language in languages}
        self.version = _version([shared, entries, *by_language.values(), *words.values()])
        for name, text in entries.items():
            styles = f"{name.removesuffix('.html')}.css"
            needed = _needed([*ENTRY.findall(text), *FIRST.get(name, [])], shared | by_language[ENGLISH])
            shared[styles] = b"".join(shared[style] for style in STYLE.findall(text))
            for language in languages:
                entry = self._entry(text, styles, needed, language)
                by_language[language][name] = _with_words(entry, words[language]).encode()
        self._of_language = {
            language: PageFiles(contents, is_at_once=language == ENGLISH) for language, contents in by_language.items()
        }
        self._shared = PageFiles(
            {name: content for name, content in shared.items() if name != LANGUAGE_MODULE}, is_at_once=True
        )
        large = (file for file in folder.rglob("*") if file.suffix in LARGE)
        self._large = {file.relative_to(folder).as_posix(): file for file in large}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request for a file."""
        if scope["type"] == "websocket":
            await WebSocketClose()(scope, receive, send)
            return
        if scope["method"] not in {"GET", "HEAD"}:
            raise HTTPException(405)
        address = _address(scope["path"])
        if address.name in self._large:
            await self._large_file(address)(scope, receive, send)
            return
        language = address.language if address.language in self._of_language else current_language()
        files = self._files(address.name, language)
        if address.name not in files:
            raise HTTPException(404)
        is_present = address.version == self.version and address.language == language
        headers = {
            "Cache-Control": FOR_EVER if is_present else ASK_AGAIN,
            "ETag": f'W/"{self.version}-{language}"',
            "Vary": "Accept-Encoding" if address.language == language else "Accept-Encoding, Accept-Language, Cookie",
        }
        if address.name in PICTURE_READERS:
            headers["Content-Security-Policy"] = READER_POLICY
        answer = _answer(await files.file(address.name), Headers(scope=scope), headers)
        await answer(scope, receive, send)

    def is_asked_for(self, scope: Scope) -> bool:
        """Return whether a request is for a file under the address of a version."""
        if scope["type"] != "http" or scope["method"] != "GET":
            return False
        name, version, _ = _address(scope["path"])
        return version is not None and (name in self._large or name in self._files(name, ENGLISH))

    def text(self, name: str, language: str = ENGLISH) -> str:
        """Return a file as it is sent."""
        return self._files(name, language).text(name)

    def _large_file(self, address: "Address") -> FileResponse:
        """Return the answer with a file of `LARGE`, which changes only together with the scripts that load it."""
        file = self._large[address.name]
        headers = {"Cache-Control": FOR_EVER if address.version == self.version else ASK_AGAIN}
        return FileResponse(file, headers=headers, media_type=LARGE[file.suffix])

    def _files(self, name: str, language: str) -> PageFiles:
        of_language = self._of_language[language]
        return of_language if name in of_language else self._shared

    def _entry(self, text: str, styles: str, modules: list[str], language: str) -> str:
        """Return an entry with one link to its joined styles, all addresses of this version and language.

        Its script, with links to the modules, stands in a template: the browser draws the entry's own words first.
        """
        preloads = "".join(f'  <link rel="modulepreload" href="{module}">\n' for module in modules)
        scripts = "".join(match[0] for match in ENTRY.finditer(text))
        joined = STYLES.sub(f'  <link rel="stylesheet" href="{styles}">\n', text)
        joined = ENTRY.sub(BEGINNING, joined).replace("</body>", PROGRAM.format(preloads + scripts))
        return LINK.sub(rf'\1="/v-{self.version}-{language}/\2"', joined)


class Address(NamedTuple):
    """What the path of a request names."""

    name: str  # of a file
    version: str | None
    language: str | None


def _address(path: str) -> Address:
    name = path.lstrip("/") or "index.html"
    version = VERSION.match(name)
    return Address(name[version.end() :], version[1], version[2]) if version else Address(name, None, None)


def _version(parts: Iterable[Mapping[str, bytes | str]]) -> str:
    """Return what changes when the program's version or a file changes."""
    digest = sha256(__version__.encode())
    for name, content in (item for part in parts for item in part.items()):
        written = content.encode() if isinstance(content, str) else content
        digest.update(f"{name} {len(written)} ".encode() + written)
    return digest.hexdigest()[:16]


def _answer(file: PageFile, asked: Headers, headers: dict[str, str]) -> Response:
    headers = {**headers, "Content-Type": file.kind}
    if asked.get("if-none-match") == headers["ETag"]:
        return Response(status_code=304, headers=headers)
    if "gzip" not in asked.get("accept-encoding", ""):
        return Response(file.content, headers=headers)
    return Response(file.compressed, headers={**headers, "Content-Encoding": "gzip"})


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


def read_entry(folder: Path, entry: str, language: str) -> dict[str, PageFile]:
    """Return an entry (an HTML file) and the files that it needs, by their names, in a language."""
    text = _with_words((folder / entry).read_text(), _entry_words(folder, language))
    styles = [name for kind, name in LINK.findall(text) if kind == "href"]
    words, scripts = language_files(folder, language), dict[str, bytes]()
    waiting = ENTRY.findall(text)
    while waiting:
        name = waiting.pop()
        if name not in scripts:
            scripts[name] = words[name] if name in words else (folder / name).read_bytes()
            waiting += _imported(name, scripts[name])
    contents = {entry: text.encode()} | {name: (folder / name).read_bytes() for name in styles} | scripts
    return {name: _page_file(name, content) for name, content in contents.items()}


def language_files(folder: Path, language: str) -> dict[str, bytes]:
    """Return the modules that differ by language, by their names: the messages of the pages and `js/language.js`.

    A module of messages (`words/pages.ftl.js`) exports them as one text, without the comments that are for translators.
    As a module they are imported, have the pages' version and are loaded at once with the others, as nothing else would
    be.
    """
    parts: dict[str, list[str]] = defaultdict(list)
    for file in sorted((folder / WORDS / language).glob("*.ftl")):
        if file.stem == IN_ENTRIES:
            continue
        module = file.stem if file.stem in ALONE else SHARED
        lines = file.read_text(encoding="utf-8").splitlines()
        parts[f"{WORDS}/{module}.ftl.js"] += [line for line in lines if not line.startswith("#")]
    texts = {name: json.dumps("\n".join(lines), ensure_ascii=False) for name, lines in parts.items()}
    modules = {name: f"export default {text};\n".encode() for name, text in texts.items()}
    source = folder / LANGUAGE_MODULE
    if source.exists():
        modules[LANGUAGE_MODULE] = source.read_bytes().replace(f'"{ENGLISH}"'.encode(), f'"{language}"'.encode())
    return modules


def _entry_words(folder: Path, language: str) -> dict[str, str]:
    """Return the messages that stand in entries, and the language itself."""
    file = folder / WORDS / language / f"{IN_ENTRIES}.ftl"
    messages = MESSAGE.findall(file.read_text(encoding="utf-8")) if file.exists() else []
    return {"language": language, **dict(messages)}


def _with_words(entry: str, words: dict[str, str]) -> str:
    return IN_ENTRY.sub(lambda place: html.escape(words[place[1]]), entry)


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
