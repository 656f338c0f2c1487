"""bodydrive behind real reverse proxies, each with its configuration of docs/proxy, over https."""

import asyncio
import json
import os
import socket
import ssl
import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import httpx
import pytest
from browser.served.recorded_clinic import furnish
from processes.served_demo import OWNER, SessionClient, free_port, printed_link, running_program
from websockets.asyncio.client import connect
from websockets.exceptions import ConnectionClosed

from app.api.proxy import INCOMPLETE
from app.scene.client_messages import SUBPROTOCOL
from app.settings import Settings
from folders import ROOT
from needed import need

NAME = "clinic.example.org"
PLACE = "/etc/ssl/clinic"  # of the certificate, in the configurations
LARGE = 72_000_000  # bytes of an archive: more than what other requests may send
OPENED_WITHIN = 60.0  # s for a socket or the 3D view of a session, beside other tests

NGINX_MAIN = """daemon off; {user}
pid {folder}/nginx.pid;
error_log stderr;
events {{}}
http {{
    access_log off;
    client_body_temp_path {folder}/bodies;
    proxy_temp_path {folder}/answers;
    include {site};
}}
"""
CADDY_MAIN = """{{
	admin off
	auto_https disable_redirects
	default_bind 127.0.0.1
}}
import {site}
"""


class Proxy(NamedTuple):
    """A program, its configuration in docs/proxy, the file that includes it, and how it is started with that file."""

    package: str  # of Debian
    site: str
    port: tuple[str, str]  # the place of the port in the configuration: as it stands there, and with another one
    main: str
    words: Callable[[Path], list[str]]


PROXIES = {
    "caddy": Proxy(
        "caddy",
        "Caddyfile",
        (f"\n{NAME} {{", f"\n{NAME}:{{port}} {{{{"),
        CADDY_MAIN,
        lambda main: ["caddy", "run", "--adapter", "caddyfile", "--config", str(main)],
    ),
    "nginx": Proxy(
        "nginx-light",
        "nginx.conf",
        ("listen 443 ssl", "listen 127.0.0.1:{port} ssl"),
        NGINX_MAIN,
        lambda main: ["nginx", "-p", str(main.parent), "-e", "stderr", "-c", str(main)],
    ),
}


class ThroughLoopback(httpx.HTTPTransport):
    """Connects to this machine, whatever name is asked for."""

    def handle_request(self, request: httpx.Request) -> httpx.Response:
        address, extensions = request.url.copy_with(host="127.0.0.1"), {"sni_hostname": request.url.host}
        sent = httpx.Request(
            request.method,
            address,
            headers=request.headers,
            stream=request.stream,
            extensions={**request.extensions, **extensions},
        )
        return super().handle_request(sent)


class Browser(SessionClient):
    """A client that reaches the clinic by the name of the proxy, and trusts its certificate only."""

    def __init__(self, port: int, certificate: Path) -> None:
        self._port, self._trust = port, ssl.create_default_context(cafile=str(certificate))
        super().__init__(f"https://{NAME}:{port}", transport=ThroughLoopback(verify=self._trust))

    def first_message(self, path: str, **more: Any) -> str | bytes:
        """Return the first message of a websocket that is opened as a page of the proxy's address does.

        It is read and written by one thread: OpenSSL's connections are not for two.
        """
        return asyncio.run(self._first_message(path, more))

    async def _first_message(self, path: str, more: dict[str, Any]) -> str | bytes:
        address = f"{NAME}:{self._port}"
        cookie = "; ".join(f"{name}={value}" for name, value in self.cookies.items())
        plain = socket.create_connection(("127.0.0.1", self._port))
        page: dict[str, Any] = {"additional_headers": {"Cookie": cookie}, "origin": f"https://{address}", **more}
        opening = connect(f"wss://{address}{path}", sock=plain, ssl=self._trust, open_timeout=OPENED_WITHIN, **page)
        async with opening as opened:
            return await asyncio.wait_for(opened.recv(), 30)


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a certificate of its own and its key."""
    folder = tmp_path_factory.mktemp("certificate")
    key = ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-keyout", folder / "key.pem")
    names = ("-subj", f"/CN={NAME}", "-addext", f"subjectAltName=DNS:{NAME}")
    words = ("openssl", "req", "-x509", *key, *names, "-days", "2", "-out", folder / "certificate.pem")
    subprocess.run(words, check=True, capture_output=True)
    return folder


def configured(proxy: Proxy, folder: Path, certificate: Path, port: int, upstream: int) -> Path:
    """Write the configuration of docs/proxy with other ports and another certificate; return what includes it."""
    text = (ROOT / "docs" / "proxy" / proxy.site).read_text(encoding="utf-8")
    here, there = proxy.port
    changes = {here: there.format(port=port), "127.0.0.1:8080": f"127.0.0.1:{upstream}"}
    for before, after in changes.items():
        assert text.count(before) == 1, before
        text = text.replace(before, after)
    assert text.count(PLACE) == 2
    site, main = folder / proxy.site, folder / "main"
    site.write_text(text.replace(PLACE, str(certificate)), encoding="utf-8")
    user = "user root;" if os.geteuid() == 0 else ""  # only its owner can open the folders of a test
    main.write_text(proxy.main.format(site=site, folder=folder, user=user), encoding="utf-8")
    return main


@contextmanager
def running(words: list[str], port: int, folder: Path) -> Iterator[None]:
    """Run a proxy until it listens on its port, and end it afterwards."""
    with (folder / "proxy.log").open("w+") as said:
        process = subprocess.Popen(words, stdout=said, stderr=said, env={**os.environ, "HOME": str(folder)})
        try:
            while not listens(port):
                assert process.poll() is None, (folder / "proxy.log").read_text()
                time.sleep(0.05)
            yield
        finally:
            process.terminate()
            process.wait(60)


def listens(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


@pytest.fixture(params=list(PROXIES))
def proxy(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Proxy:
    monkeypatch.setenv("PATH", f"{os.environ['PATH']}:/usr/sbin")  # where Debian has nginx
    chosen = PROXIES[request.param]
    need(request.param, chosen.package)
    return chosen


def test_a_clinic_is_used_through_the_proxy(proxy: Proxy, certificate: Path, tmp_path: Path) -> None:
    port, upstream = free_port(), free_port()
    main = configured(proxy, tmp_path, certificate, port, upstream)
    name = f"{NAME}:{port}"
    furnish(Settings(state=tmp_path / "clinic"))  # a patient with recorded trials
    words = ("serve", "--port", str(upstream), "--state", str(tmp_path / "clinic"))
    with running_program(*words, "--behind-proxy", "127.0.0.1", "--name", name) as served:
        with running(proxy.words(main), port, tmp_path):
            link, _, code = printed_link(served).partition("#setup=")
            assert link == f"https://{name}/"
            with Browser(port, certificate / "certificate.pem") as browser:
                walk_through(browser, code)
                if proxy.site == "nginx.conf":
                    with Browser(port, certificate / "certificate.pem") as visitor:
                        look_from_elsewhere(browser, visitor)
            past_the_proxy = httpx.get(f"http://127.0.0.1:{upstream}/")
            assert (past_the_proxy.status_code, past_the_proxy.json()["detail"]) == (403, str(INCOMPLETE))
        served.terminate()
        _, errors = served.communicate(timeout=30)
    assert served.returncode == 0
    assert "Traceback" not in errors


def walk_through(browser: Browser, code: str) -> None:
    """Sign in, see the live picture, upload a recording and what is no archive, open the 3D view, and stop."""
    forged = {"X-Forwarded-For": "6.6.6.6", "X-Forwarded-Host": "evil.example"}  # the proxy replaces them
    answer = browser.post("/auth/setup", json={"code": code, **OWNER}, headers=forged)
    assert answer.json()["role"] == "owner"
    cookies = answer.headers.get_list("set-cookie")
    assert cookies
    assert all("; Secure" in cookie for cookie in cookies)
    page = browser.get(f"{browser.headers['Origin']}/")
    assert page.status_code == 200
    assert f"wss://{page.request.url.netloc.decode()}" in page.headers["content-security-policy"]
    assert "control" in json.loads(browser.first_message("/api/v1/live"))
    # larger than the 1 MB that nginx takes unless it is told otherwise
    rows = "\n".join(f"{i / 100},{i},{i}" for i in range(80_000))
    sent = browser.post("/equipment/files", files={"file": ("arm.csv", f"t,a,b\n{rows}\n")})
    assert sent.status_code == 201, sent.text
    refused = browser.post("/archives", content=bytes(LARGE))  # the proxy passes it on, and bodydrive reads it
    assert (refused.status_code, "This is no archive" in refused.text) == (422, True), refused.text
    patient = browser.post("/patients", json={"code": "P-2", "pseudonym": "Otter"}).json()
    now = browser.get("/session").json()["session"]
    begun = browser.post("/session", json={"patient_id": patient["id"], "ends": now and now["id"]})
    assert begun.status_code == 200, begun.text
    assert browser.get(f"{browser.headers['Origin']}/view/clinician/").status_code == 200
    assert first_picture(browser, "/view/clinician")
    assert browser.post("/control/stop").status_code == 200


def look_from_elsewhere(browser: Browser, visitor: Browser) -> None:
    """Read the story of a session, see a trial again in 3D, and share the course with somebody who is not signed in.

    No proxy treats these requests otherwise than those of `walk_through`: one of the proxies is enough.
    """
    origin = browser.headers["Origin"]
    session = browser.get("/patients/1/sessions").json()[0]["id"]
    story = browser.get(f"/sessions/{session}/story").json()
    assert [event["kind"] for event in story["events"]].count("trial") == 2
    trial = browser.get("/trials?patient=1").json()[0]["id"]
    replay = browser.post("/replays", json={"trial": trial}).json()["id"]
    assert browser.get(f"{origin}/view/replay/{replay}/").status_code == 200
    assert first_picture(browser, f"/view/replay/{replay}")
    assert browser.post(f"/replays/{replay}/at", json={"t": 5.0}).status_code == 204
    assert browser.delete(f"/replays/{replay}").status_code == 204

    assert browser.put("/patients/1/consents/sharing", json={"given": "2026-03-01"}).status_code == 200
    made = browser.post("/patients/1/shares", json={"days": 1}).json()
    page, _, token = made["url"].partition("#")
    assert (page, made["message"]) == (f"{origin}/share.html", "")
    assert visitor.get(page).status_code == 200
    assert visitor.get("/shared").status_code == 401
    opened = visitor.post("/shared/open", json={"token": token, "pin": made["pin"]})
    assert opened.status_code == 204, opened.text
    assert "; Secure" in opened.headers["set-cookie"]
    shared = visitor.get("/shared").json()
    assert (shared["code"], len(shared["stories"])) == ("P-1", 1)
    assert visitor.get(f"/sessions/{session}/story").status_code == 401


def first_picture(browser: Browser, path: str) -> str | bytes:
    """Return the first message of a 3D view; the clinician's opens after its session."""
    until = time.monotonic() + OPENED_WITHIN
    while True:
        try:
            return browser.first_message(path, subprotocols=[SUBPROTOCOL])
        except ConnectionClosed:
            assert time.monotonic() < until
            time.sleep(0.2)


@pytest.mark.parametrize("name", list(PROXIES))
def test_the_configurations_fit_the_page(name: str, tmp_path: Path) -> None:
    """Also where no proxy is installed: what the test changes in a configuration stands in it once."""
    assert configured(PROXIES[name], tmp_path, tmp_path, 1, 2).is_file()
