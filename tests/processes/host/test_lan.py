"""A real `bodydrive serve --lan`: https for other machines, and over http only the page that explains."""

import asyncio
import plistlib
import re
import socket
import ssl
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest
from processes.host.served_lan import HOSTS, NAME, OWNER, ServedLan, served_lan
from processes.served_demo import bodydrive
from websockets.asyncio.client import connect
from websockets.exceptions import InvalidStatus
from websockets.typing import Origin

from app.api.pages import language_files, read_entry
from event_loop import in_event_loop
from folders import ROOT

FLUENT = "/vendor/@fluent/bundle/"
pytestmark = pytest.mark.xdist_group("lan")  # one program for all of them


@pytest.fixture(scope="module")
def lan(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ServedLan]:
    with served_lan(tmp_path_factory.mktemp("lan") / "clinic") as served:
        with served.client() as owner:
            made = owner.post("/api/v1/auth/setup", json={"code": served.code, **OWNER})
            assert made.json()["role"] == "owner"
        yield served


def test_one_code_and_one_link_without_a_local_name_are_printed(lan: ServedLan) -> None:
    assert lan.page.startswith("http://127.0.0.1:")
    blocks = [line for line in lan.printed if re.fullmatch("[█▀▄ ]{20,}", line)]
    assert len(blocks) > 10
    assert sum("authority was made" in line for line in lan.printed) == 1


@pytest.mark.parametrize("name", [*HOSTS, "localhost", NAME, f"{NAME.split('.')[0]}.local"])
def test_a_client_that_trusts_the_authority_gets_the_pages_by_every_name(lan: ServedLan, name: str) -> None:
    sent = {"Host": f"{name}:{lan.port}"}
    with lan.client(name if name in HOSTS else HOSTS[1]) as client:
        answer = client.get("/", headers=sent, extensions={} if name in HOSTS else {"sni_hostname": name})
    assert answer.status_code == 200
    assert answer.headers["strict-transport-security"] == "max-age=2592000"  # decision 41
    with pytest.raises(httpx.ConnectError, match="certificate verify failed"):
        httpx.get(f"https://{HOSTS[0]}:{lan.port}/")


@in_event_loop  # a thread more would share the TLS connection, which OpenSSL does not allow
async def test_a_person_signs_in_over_https_and_gets_the_live_socket(lan: ServedLan) -> None:
    with lan.client(HOSTS[1]) as client:
        assert client.post("/api/v1/auth/sign-in", json=OWNER).json()["signed_in"]
        names = {cookie.name for cookie in client.cookies.jar}
        assert "__Host-bodydrive_sign_in" in names
        assert all(cookie.secure for cookie in client.cookies.jar)
        cookie = f"__Host-bodydrive_sign_in={client.cookies['__Host-bodydrive_sign_in']}"
    base = f"https://{HOSTS[1]}:{lan.port}"
    address = f"{base.replace('https', 'wss')}/api/v1/live"
    page: dict[str, Any] = {"ssl": lan.trust, "additional_headers": {"Cookie": cookie}}
    async with connect(address, origin=Origin(base), **page) as live:
        assert await asyncio.wait_for(live.recv(), 60)
    with pytest.raises(InvalidStatus):
        await connect(address, origin=Origin(base.replace("https", "http")), **page)


@in_event_loop
async def test_over_http_there_is_the_page_that_explains_and_nothing_else(lan: ServedLan) -> None:
    """Request every route of the application, every page and file, and the sockets."""
    with lan.client() as client:
        client.post("/api/v1/auth/sign-in", json=OWNER)
        routes = client.get("/api/v1/openapi.json").json()["paths"]
        cookie = f"__Host-bodydrive_sign_in={client.cookies['__Host-bodydrive_sign_in']}"
    assert len(routes) > 50
    wanted = [(method.upper(), re.sub(r"\{\w+\}", "1", path)) for path, methods in routes.items() for method in methods]
    static = ROOT / "web_static"
    files = [file.relative_to(static).as_posix() for file in static.rglob("*") if file.is_file()]
    wanted += [("GET", f"/{file}") for file in [*files, *language_files(static, "en")]]
    assert ("GET", "/vendor/preact/preact.js") in wanted
    wanted += [("GET", path) for path in ("/index.html", "/view/clinician/", "/view/patient/")]
    answered = set()
    headers = {"Cookie": f"{cookie}; {cookie.replace('__Host-', '')}", "Origin": lan.page.rstrip("/")}
    with httpx.Client(base_url=lan.page, headers=headers) as plain:
        for method, path in wanted:
            answer = plain.request(method, path)
            assert answer.status_code in {200, 404, 405}
            if answer.status_code == 200:
                answered.add(path)
        assert plain.get("/").content == read_entry(static, "tablet.html", "en")["tablet.html"].content
    page = {path for path in answered if not path.startswith(("/js/tablet", "/css/t", "/css/base", FLUENT))}
    assert page == {"/tablet.html", "/icon.svg", "/css/shell/forced_colors.css"} | {
        "/js/language.js",
        "/js/shell/theme.js",
        "/js/widgets/dom.js",
        "/js/widgets/format.js",
        "/js/words.js",
        "/words/tablet.ftl.js",
    }
    for path in ("/api/v1/live", "/view/clinician/"):
        with pytest.raises(InvalidStatus):
            await connect(f"{lan.page.replace('http', 'ws').rstrip('/')}{path}", additional_headers={"Cookie": cookie})


def test_the_pages_answer_http_on_the_loopback_address_of_this_machine_only(lan: ServedLan) -> None:
    assert httpx.get(lan.local).status_code == 200
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection((HOSTS[1], urlsplit(lan.local).port))
    with pytest.raises(httpx.HTTPError):  # the port of https does not speak http
        httpx.get(f"http://{HOSTS[0]}:{lan.port}/")


def test_the_profile_and_the_certificate_are_of_one_root_and_say_so(lan: ServedLan) -> None:
    answer = httpx.get(f"{lan.page}bodydrive.mobileconfig")
    assert answer.headers["content-type"] == "application/x-apple-aspen-config"
    profile = plistlib.loads(answer.content)
    (inside,) = profile["PayloadContent"]
    assert inside["PayloadType"] == "com.apple.security.root"
    assert inside["PayloadContent"] == ssl.PEM_cert_to_DER_cert(lan.root)
    assert len({profile["PayloadUUID"], inside["PayloadUUID"]}) == 2
    assert httpx.get(f"{lan.page}bodydrive.mobileconfig").content == answer.content


def test_the_check_of_the_page_that_explains(lan: ServedLan) -> None:
    with lan.client() as client:
        answer = client.get(lan.facts["check"])
    assert answer.json() == {"fingerprint": lan.facts["fingerprint"]}
    assert answer.headers["access-control-allow-origin"] == "*"
    by_second = httpx.get(f"{lan.page.replace(HOSTS[0], HOSTS[1])}facts.json").json()
    assert urlsplit(by_second["link"]).hostname == HOSTS[1]
    foreign = httpx.get(f"{lan.page}facts.json", headers={"Host": "evil.example"}).json()
    assert urlsplit(foreign["link"]).hostname == HOSTS[0]


def test_a_link_for_a_further_tablet_is_shown_to_who_is_signed_in(lan: ServedLan) -> None:
    with lan.client() as client:
        assert client.get("/api/v1/tablets").status_code == 401
        client.post("/api/v1/auth/sign-in", json=OWNER)
        shown = client.get("/api/v1/tablets").json()
    assert shown["url"] == lan.page
    assert shown["pages"] == f"https://127.0.0.1:{lan.port}/"


def test_a_patients_screen_on_another_machine_is_paired_without_a_restart(lan: ServedLan) -> None:
    with httpx.Client(base_url=lan.local, headers={"Origin": lan.local.rstrip("/")}, timeout=60) as here:
        here.post("/api/v1/auth/sign-in", json=OWNER)
        nobody = {"Patient-Session": "none"}
        patient = here.post("/api/v1/patients", json={"code": "P-1", "pseudonym": "Heron"}, headers=nobody).json()
        opened = here.post("/api/v1/session", json={"patient_id": patient["id"]}, headers=nobody).json()
        present = {"Patient-Session": str(opened["session"]["id"])}
        offered = here.post("/api/v1/patient-screen/pairing", headers=present).json()
        assert offered["url"] == f"https://{HOSTS[0]}:{lan.port}/patient.html#pair={offered['code']}"
        assert lan.page in offered["message"]
        with lan.client(HOSTS[1]) as screen:
            assert screen.post("/api/v1/patient-screen/pair", json={"code": offered["code"]}).json() == {
                "state": "paired"
            }
            assert "__Host-bodydrive_screen" in screen.cookies
            assert screen.get("/api/v1/patient-screen/me").json() == {"state": "paired"}
            assert screen.get("/api/v1/patients").status_code == 401
        assert here.delete("/api/v1/session", headers=present).is_success


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("serve", "--host", "0.0.0.0"), r"could read and change what they send: use 'bodydrive serve --lan'"),
        (("demo", "--host", "0.0.0.0"), r"could read and change what they send"),
        (("serve", "--host", "127.0.0.1", "--host", "127.0.0.2"), r"Without --lan there is one address only"),
        (("serve", "--certificate", "a", "--key", "b"), r"together with --lan"),
        (("serve", "--lan", "--host", "127.0.0.1", "--certificate", "a"), r"A certificate needs its key"),
        (("serve", "--lan", "--host", "127.0.0.1", "--certificate", "a", "--key", "b"), r"a cannot be read"),
    ],
)
def test_what_cannot_be_served_is_one_sentence(tmp_path: Path, words: tuple[str, ...], sentence: str) -> None:
    state = () if words[0] == "demo" else ("--state", str(tmp_path / "clinic"))
    out, errors = bodydrive(*words, "--port", "0", *state).communicate(timeout=60)
    assert out == ""
    assert re.fullmatch(rf"bodydrive: .*{sentence}.*\n", errors)


def test_a_damaged_authority_ends_the_start_in_one_sentence(tmp_path: Path) -> None:
    folder = tmp_path / "authority"
    folder.mkdir()
    (folder / "root.pem").write_text("damaged")
    words = ("serve", "--lan", "--host", "127.0.0.1", "--port", "0", "--state", str(tmp_path))
    out, errors = bodydrive(*words).communicate(timeout=60)
    assert (out, errors.count("\n")) == ("", 1)
    assert "root.pem is damaged" in errors
