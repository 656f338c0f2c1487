"""The files of the pages: kept by a browser under the address of their version, asked for again under any other."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.middleware import Middleware
from starlette.testclient import TestClient
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.pages import Pages, PagesFirst, language_files, read_entry
from app.settings import static_folder
from app.texts import LANGUAGES, reader_language

ENTRY = """<!doctype html>
<head>
  <link rel="icon" href="icon.svg">
  <link rel="stylesheet" href="css/one.css">
  <link rel="stylesheet" href="css/two.css">
  <script type="module" src="js/main.js"></script>
</head>
<body>
</body>
"""
FILES = {
    "index.html": ENTRY,
    "icon.svg": "<svg/>",
    "css/one.css": "a { color: red }\n",
    "css/two.css": "b { color: blue }\n",
    "js/main.js": 'import { one } from "./one.js";\nimport "./deep/two.js";\n/** @import { X } from "./types" */\n',
    "js/one.js": 'import {\n  two,\n} from "./deep/two.js";\nexport const text = "./no.js";\n',
    "js/deep/two.js": 'export { one } from "../one.js";\n',
    "js/pages/drive/drive.js": "",
    "notes.txt": "not for browsers",
}


def put(folder: Path, **changed: str) -> Path:
    for name, content in {**FILES, **changed}.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(content)
    return folder


@pytest.fixture
def pages(tmp_path: Path) -> Pages:
    return Pages(put(tmp_path))


def browser_of(pages: Pages, *middleware: Any) -> TestClient:
    """Return a browser of an application that has nothing but these pages."""
    app = Starlette(middleware=[Middleware(each) for each in middleware])
    app.mount("/", pages)
    return TestClient(app)


@pytest.fixture
def client(pages: Pages) -> Any:
    with browser_of(pages) as client:
        yield client


def test_an_entry_names_its_styles_and_every_module_once_in_this_version(pages: Pages, client: Any) -> None:
    at = f"/v-{pages.version}-en"
    modules = "".join(
        f'  <link rel="modulepreload" href="{at}/js/{name}.js">\n'
        for name in ("main", "one", "deep/two", "pages/drive/drive")
    )
    expected = f"""<!doctype html>
<head>
  <link rel="icon" href="{at}/icon.svg">
  <link rel="stylesheet" href="{at}/index.css">
  <script type="module" src="{at}/js/first_picture.js"></script>
</head>
<body>
  <template id="program">
{modules}  <script type="module" src="{at}/js/main.js"></script>
  </template>
</body>
"""
    assert client.get("/").text == expected
    assert client.get(f"{at}/index.css").text == FILES["css/one.css"] + FILES["css/two.css"]


def test_a_file_of_this_version_is_never_asked_for_again(pages: Pages, client: Any) -> None:
    answer = client.get(f"/v-{pages.version}-en/js/main.js")
    assert answer.text == FILES["js/main.js"]
    assert answer.headers["content-type"] == "text/javascript; charset=utf-8"
    assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"


@pytest.mark.parametrize("path", ["/", "/js/main.js", "/v-0123456789abcdef-en/js/main.js"])
def test_an_entry_and_any_other_address_are_asked_for_each_time(client: Any, path: str) -> None:
    answer = client.get(path)
    assert (answer.status_code, answer.headers["cache-control"]) == (200, "no-cache")
    again = client.get(path, headers={"If-None-Match": answer.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")


@pytest.mark.parametrize("changed", ["js/one.js", "css/two.css", "index.html"])
def test_a_changed_file_changes_the_version(pages: Pages, tmp_path: Path, changed: str) -> None:
    assert Pages(tmp_path).version == pages.version
    put(tmp_path, **{changed: FILES[changed] + " "})
    assert Pages(tmp_path).version != pages.version


def test_a_browser_that_can_unpack_gets_it_packed(client: Any) -> None:
    packed = client.get("/css/one.css", headers={"Accept-Encoding": "br, gzip"})
    plain = client.get("/css/one.css", headers={"Accept-Encoding": "identity"})
    assert packed.headers["content-encoding"] == "gzip"
    assert "content-encoding" not in plain.headers
    assert packed.content == plain.content == FILES["css/one.css"].encode()
    assert packed.headers["vary"] == plain.headers["vary"] == "Accept-Encoding, Accept-Language, Cookie"


@pytest.mark.parametrize(
    "path", ["/notes.txt", "/js", "/js/", "/../secret", "/v-1-en/", "/v-x/js/main.js", "/v-1/js/main.js", "/%00"]
)
def test_what_is_no_file_of_the_pages_is_not_there(client: Any, path: str) -> None:
    assert client.get(path).status_code == 404


def test_a_file_is_only_read(client: Any) -> None:
    assert (client.head("/css/one.css").status_code, client.post("/css/one.css").status_code) == (200, 405)


def test_a_script_of_others_is_served_as_a_file_of_the_pages(tmp_path: Path) -> None:
    pages = Pages(put(tmp_path, **{"vendor/charts.js": "draw()", "vendor/charts-LICENSE.txt": "MIT"}))
    with browser_of(pages) as client:
        for _ in range(2):
            answer = client.get(f"/v-{pages.version}-en/vendor/charts.js")
            assert (answer.status_code, answer.text) == (200, "draw()")
        assert client.get("/vendor/charts-LICENSE.txt").status_code == 404
    assert Pages(put(tmp_path, **{"vendor/charts.js": "draw(2)"})).version != pages.version


def test_a_large_file_is_sent_as_it_is_and_kept_for_as_long_as_the_scripts_that_load_it(tmp_path: Path) -> None:
    put(tmp_path)
    (tmp_path / "vendor").mkdir()
    (tmp_path / "vendor" / "pose.wasm").write_bytes(bytes(range(256)))
    pages = Pages(tmp_path)
    for middleware in ((), (PagesFirst,)):
        app = Starlette()
        app.mount("/", pages)
        for each in middleware:
            app.add_middleware(each, pages=pages)
        with TestClient(app) as client:
            kept = client.get(f"/v-{pages.version}-en/vendor/pose.wasm", headers={"Accept-Encoding": "gzip"})
            assert (kept.content, kept.headers["content-type"]) == (bytes(range(256)), "application/wasm")
            assert kept.headers["cache-control"] == "public, max-age=31536000, immutable"
            assert "content-encoding" not in kept.headers
            assert client.get("/vendor/pose.wasm").headers["cache-control"] == "no-cache"
            assert client.get(f"/v-{pages.version}-en/vendor/other.wasm").status_code == 404
            assert client.post("/vendor/pose.wasm").status_code == 405


def test_only_what_reads_a_camera_s_pictures_may_compile_and_it_reaches_no_other_machine() -> None:
    pages = Pages(static_folder())
    with browser_of(pages) as client:
        names = [name for name in shown_files() if name.endswith((".js", ".html"))]
        policies = {
            name: policy
            for name in names
            if (policy := client.get(f"/v-{pages.version}-en/{name}").headers.get("content-security-policy"))
        }
    assert policies.keys() == {"js/camera/pose_engine.js", "camera.html"}
    (policy,) = set(policies.values())
    rules = dict(rule.split(" ", 1) for rule in policy.split("; "))
    assert rules["script-src"] == "'self' 'wasm-unsafe-eval'"
    assert (rules["default-src"], rules["connect-src"], rules["form-action"]) == ("'none'", "'self'", "'none'")


def shown_files() -> list[str]:
    """Return the names of all files of the pages but those of others."""
    folder = static_folder()
    files = (file.relative_to(folder).as_posix() for file in folder.rglob("*") if file.is_file())
    return [name for name in files if not name.startswith(("vendor/", "words/"))]


def test_every_module_that_a_page_imports_is_preloaded_and_there() -> None:
    with browser_of(Pages(static_folder())) as client:
        for entry in ("index", "patient", "stereo"):
            links = re.findall(r'(?:href|src)="([^"]+)"', client.get(f"/{entry}.html").text)
            assert len(links) > 20
            assert {client.get(link).status_code for link in links} == {200}


TWO_LANGUAGES = ("en", "es")
IN_SPANISH = {"Cookie": "language=es"}
MESSAGES = {
    "words/en/a.ftl": '### For translators\n\n# why\none = "One" – {" "}\n    # two\n',
    "words/en/b.ftl": "two = Two\n",
    "words/en/entries.ftl": "# why\nstarting = One <moment>\n",
    "words/en/help.ftl": "help-one = Help\n",
    "words/es/b.ftl": "two = Dos\n",
    "words/es/entries.ftl": "starting = Un momento\n",
    "words/es/help.ftl": "help-one = Ayuda\n",
    "js/language.js": 'export const LANGUAGE = "en";\n',
    "js/main.js": 'import messages from "../words/pages.ftl.js";\nimport "./language.js";\n',
    "index.html": ENTRY.replace("<head>", '<html lang="{ language }">\n<head>').replace(
        "<body>", "<p>{ starting }</p>"
    ),
}


class Cookies:
    """Middleware that makes the language of the cookie that of the request."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        cookie = Headers(scope=scope).get("cookie", "") if scope["type"] == "http" else ""
        with reader_language(cookie.removeprefix("language=") or "en"):
            await self._app(scope, receive, send)


@pytest.fixture
def translated(tmp_path: Path) -> Any:
    """Return the pages in two languages, and a client."""
    pages = Pages(put(tmp_path, **MESSAGES), TWO_LANGUAGES)
    with browser_of(pages, Cookies) as client:
        yield pages, client


def test_the_modules_of_a_language_have_its_messages_without_comments_and_its_name(tmp_path: Path) -> None:
    modules = language_files(put(tmp_path, **MESSAGES), "en")
    assert modules.pop("js/language.js") == b'export const LANGUAGE = "en";\n'
    texts = {
        name: json.loads(content.decode().removeprefix("export default ")[:-2]) for name, content in modules.items()
    }
    assert texts == {
        "words/pages.ftl.js": '\none = "One" – {" "}\n    # two\ntwo = Two',
        "words/help.ftl.js": "help-one = Help",
    }
    assert language_files(tmp_path, "es") == {
        "words/pages.ftl.js": b'export default "two = Dos";\n',
        "words/help.ftl.js": b'export default "help-one = Ayuda";\n',
        "js/language.js": b'export const LANGUAGE = "es";\n',
    }


def test_an_entry_is_in_the_language_of_the_request_and_so_is_all_that_it_loads(translated: Any) -> None:
    pages, client = translated
    english, spanish = client.get("/"), client.get("/", headers=IN_SPANISH)
    for answer, language, words in ((english, "en", "One &lt;moment&gt;"), (spanish, "es", "Un momento")):
        assert f'<html lang="{language}">' in answer.text
        assert f"<p>{words}</p>" in answer.text
        assert answer.text.count("/v-") == answer.text.count(f'"/v-{pages.version}-{language}/') > 5
        assert answer.headers["vary"] == "Accept-Encoding, Accept-Language, Cookie"
    known = {"If-None-Match": english.headers["etag"]}
    assert client.get("/", headers=known).status_code == 304
    assert client.get("/", headers=known | IN_SPANISH).status_code == 200


@pytest.mark.parametrize("asked", [{}, IN_SPANISH])
def test_an_address_names_the_language_whoever_asks(translated: Any, asked: dict[str, str]) -> None:
    pages, client = translated
    for language, two in (("en", "Two"), ("es", "Dos")):
        at = f"/v-{pages.version}-{language}"
        words = client.get(f"{at}/words/pages.ftl.js", headers=asked)
        assert two in words.text
        assert words.headers["cache-control"] == "public, max-age=31536000, immutable"
        assert words.headers["vary"] == "Accept-Encoding"
        assert f'"{language}"' in client.get(f"{at}/js/language.js", headers=asked).text
        assert client.get(f"{at}/css/one.css", headers=asked).text == FILES["css/one.css"]
    other = client.get(f"/v-{pages.version}-fr/words/pages.ftl.js", headers=IN_SPANISH)
    assert ("Dos" in other.text, other.headers["cache-control"]) == (True, "no-cache")


def test_messages_are_loaded_with_what_imports_them_and_have_its_version(tmp_path: Path, translated: Any) -> None:
    pages, client = translated
    modules = language_files(tmp_path, "en")
    assert f'"/v-{pages.version}-en/words/pages.ftl.js">' in pages.text("index.html")
    assert "help.ftl" not in pages.text("index.html")
    assert pages.text("words/pages.ftl.js").encode() == modules["words/pages.ftl.js"]
    answer = client.get("/words/pages.ftl.js")
    assert answer.headers["content-type"] == "text/javascript; charset=utf-8"
    assert client.get("/words/en/b.ftl").status_code == client.get("/words/entries.ftl.js").status_code == 404
    for name in ("words/en/b.ftl", "words/es/b.ftl", "words/es/entries.ftl"):
        put(tmp_path, **MESSAGES | {name: MESSAGES[name] + "three = 3\n"})
        assert Pages(tmp_path, TWO_LANGUAGES).version != pages.version


def test_an_entry_is_read_in_a_language(tmp_path: Path) -> None:
    read = read_entry(put(tmp_path, **MESSAGES), "index.html", "es")
    assert b"Un momento" in read["index.html"].content
    assert {name: read[name].content for name in ("words/pages.ftl.js", "js/language.js")} == {
        name: content for name, content in language_files(tmp_path, "es").items() if "help" not in name
    }


def test_the_pages_are_in_each_language_without_a_place_that_has_no_words() -> None:
    pages = Pages(static_folder())
    for language in LANGUAGES:
        for entry in static_folder().glob("*.html"):
            text = pages.text(entry.name, language)
            assert f'<html lang="{language}">' in text
            assert "{" not in text


def test_no_route_is_looked_through_for_a_file_of_a_version(pages: Pages) -> None:
    app = Starlette()
    app.add_middleware(PagesFirst, pages=pages)  # there is no route at all
    with TestClient(app) as client:
        at = f"/v-{pages.version}-en"
        assert client.get(f"{at}/js/one.js").text == FILES["js/one.js"]
        assert client.get("/v-0-en/js/one.js").headers["cache-control"] == "no-cache"
        for other in ("/js/one.js", f"{at}/js/three.js", f"{at}/notes.txt", "/"):
            assert client.get(other).status_code == 404
        assert client.post(f"{at}/js/one.js").status_code == 404
