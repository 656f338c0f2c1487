"""The files of the pages: kept by a browser under the address of their version, asked for again under any other."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from starlette.applications import Starlette
from starlette.testclient import TestClient

from app.api.pages import Pages, PagesFirst, read_entry, word_modules
from app.settings import static_folder

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


@pytest.fixture
def client(pages: Pages) -> Any:
    app = Starlette()
    app.mount("/", pages)
    with TestClient(app) as client:
        yield client


def test_an_entry_names_its_styles_and_every_module_once_in_this_version(pages: Pages, client: Any) -> None:
    at = f"/v-{pages.version}"
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
    answer = client.get(f"/v-{pages.version}/js/main.js")
    assert answer.text == FILES["js/main.js"]
    assert answer.headers["content-type"] == "text/javascript; charset=utf-8"
    assert answer.headers["cache-control"] == "public, max-age=31536000, immutable"


@pytest.mark.parametrize("path", ["/", "/js/main.js", "/v-0123456789abcdef/js/main.js"])
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
    assert {answer.headers["vary"] for answer in (packed, plain)} == {"Accept-Encoding"}


@pytest.mark.parametrize("path", ["/notes.txt", "/js", "/js/", "/../secret", "/v-1/", "/v-x/js/main.js", "/%00"])
def test_what_is_no_file_of_the_pages_is_not_there(client: Any, path: str) -> None:
    assert client.get(path).status_code == 404


def test_a_file_is_only_read(client: Any) -> None:
    assert client.head("/css/one.css").status_code == 200
    assert client.post("/css/one.css").status_code == 405


def test_a_script_of_others_is_compressed_when_it_is_first_asked_for(tmp_path: Path) -> None:
    pages = Pages(put(tmp_path, **{"vendor/charts.js": "draw()", "vendor/charts-LICENSE.txt": "MIT"}))
    app = Starlette()
    app.mount("/", pages)
    with TestClient(app) as client:
        for _ in range(2):
            answer = client.get(f"/v-{pages.version}/vendor/charts.js")
            assert (answer.status_code, answer.text) == (200, "draw()")
        assert client.get("/vendor/charts-LICENSE.txt").status_code == 404
    assert Pages(put(tmp_path, **{"vendor/charts.js": "draw(2)"})).version != pages.version


def test_every_module_that_a_page_imports_is_preloaded_and_there() -> None:
    pages = Pages(static_folder())
    app = Starlette()
    app.mount("/", pages)
    with TestClient(app) as client:
        for entry in ("index", "patient", "stereo"):
            links = re.findall(r'(?:href|src)="([^"]+)"', client.get(f"/{entry}.html").text)
            assert len(links) > 20
            assert {client.get(link).status_code for link in links} == {200}


MESSAGES = {
    "words/en/a.ftl": '### For translators\n\n# why\none = "One" – {" "}\n    # two\n',
    "words/en/b.ftl": "two = Two\n",
    "words/en/help.ftl": "help-one = Help\n",
    "words/es/b.ftl": "two = Dos\n",  # a language that no page offers yet
    "js/main.js": 'import messages from "../words/en/pages.ftl.js";\n',
}


def test_messages_are_modules_of_a_language_without_comments(tmp_path: Path) -> None:
    made = word_modules(put(tmp_path, **MESSAGES))
    texts = {name: json.loads(content.decode().removeprefix("export default ")[:-2]) for name, content in made.items()}
    assert texts == {
        "words/en/pages.ftl.js": '\none = "One" – {" "}\n    # two\ntwo = Two',
        "words/en/help.ftl.js": "help-one = Help",
    }


def test_messages_are_loaded_with_what_imports_them_and_have_its_version(tmp_path: Path) -> None:
    pages = Pages(put(tmp_path, **MESSAGES))
    module = word_modules(tmp_path)["words/en/pages.ftl.js"]
    assert f'"/v-{pages.version}/words/en/pages.ftl.js">' in pages.text("index.html")
    assert "help.ftl" not in pages.text("index.html")
    assert pages.text("words/en/pages.ftl.js") == module.decode()
    assert read_entry(tmp_path, "index.html")["words/en/pages.ftl.js"].content == module
    assert Pages(put(tmp_path, **{"words/en/b.ftl": "two = Deux\n"})).version != pages.version
    app = Starlette()
    app.mount("/", pages)
    with TestClient(app) as client:
        assert client.get("/words/en/pages.ftl.js").headers["content-type"] == "text/javascript; charset=utf-8"
        assert client.get("/words/en/b.ftl").status_code == 404


def test_no_route_is_looked_through_for_a_file_of_a_version(pages: Pages) -> None:
    app = Starlette()
    app.add_middleware(PagesFirst, pages=pages)  # there is no route at all
    with TestClient(app) as client:
        at = f"/v-{pages.version}"
        assert client.get(f"{at}/js/one.js").text == FILES["js/one.js"]
        assert client.get("/v-0/js/one.js").headers["cache-control"] == "no-cache"
        for other in ("/js/one.js", f"{at}/js/three.js", f"{at}/notes.txt", "/"):
            assert client.get(other).status_code == 404
        assert client.post(f"{at}/js/one.js").status_code == 404
