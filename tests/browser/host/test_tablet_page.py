"""A tablet that meets the program for the first time: Chromium with and without the clinic's authority.

The authority is installed into the browser's own store by `certutil` (Debian's libnss3-tools), as a person would do it
in the settings.
"""

import os
import re
import socket
import ssl
import subprocess
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from browser.conftest import CHROMIUM, modest
from cryptography import x509
from playwright.sync_api import BrowserContext, Error, Playwright
from processes.host.served_lan import HOSTS, NAME, OWNER, ServedLan, served_lan

from app.clock import utc_now
from app.host.authority import make_leaf, read_identity
from app.host.certificate import KEY
from needed import need

FOREIGN = "bank.example"
# For one page; Playwright's own clock would be that of every page of the tablet.
WRONG_CLOCK = """(() => {
  const Right = Date, behind = Right.now() - Right.UTC(2001, 0);
  window.Date = class extends Right {
    constructor(...given) { super(...(given.length ? given : [Right.now() - behind])); }
    static now() { return Right.now() - behind; }
  };
})()"""


@pytest.fixture(scope="module")
def lan(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ServedLan]:
    with served_lan(tmp_path_factory.mktemp("lan") / "clinic") as served:
        yield served


@pytest.fixture(scope="module", autouse=True)
def _programs() -> None:
    """Skip these tests, or fail, where a program that they start is missing."""
    for command, package in (("chromium", "chromium"), ("certutil", "libnss3-tools")):
        need(command, package)


@contextmanager
def tablet(playwright: Playwright, home: Path, root: str | None = None, **options: Any) -> Iterator[BrowserContext]:
    """Yield a browser with a home of its own, which trusts `root` (PEM).

    A page that could not be loaded is not closed by its test but with the browser: Chromium drops a page's close that
    comes while the error page takes its place, and Playwright then waits for ever (crbug.com/536385539).
    """
    home.mkdir(exist_ok=True)
    store = home / ".pki" / "nssdb"
    if root is not None:
        store.mkdir(parents=True)
        (home / "root.crt").write_text(root)
        database = f"sql:{store}"
        subprocess.run(["certutil", "-d", database, "-N", "--empty-password"], check=True)
        words = ["-A", "-t", "C,,", "-n", "bodydrive", "-i", str(home / "root.crt")]
        subprocess.run(["certutil", "-d", database, *words], check=True)
    names = f"MAP {NAME} {HOSTS[1]}, MAP {FOREIGN} {HOSTS[1]}"
    context = playwright.chromium.launch_persistent_context(
        str(home / "profile"),
        executable_path=modest("chromium", home),
        args=[*CHROMIUM, f"--host-resolver-rules={names}"],
        env={**os.environ, "HOME": str(home)},
        **options,
    )
    try:
        yield context
    finally:
        context.close()


@pytest.fixture(scope="module")
def stranger(
    playwright: Playwright, lan: ServedLan, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[BrowserContext]:
    """Yield a tablet that does not know the clinic's authority: to start one takes longer than most tests of it."""
    with tablet(playwright, tmp_path_factory.mktemp("stranger")) as context:
        yield context


@pytest.fixture(scope="module")
def trusting(
    playwright: Playwright, lan: ServedLan, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[BrowserContext]:
    """Yield a tablet into which the clinic's authority was installed."""
    with tablet(playwright, tmp_path_factory.mktemp("trusting"), lan.root) as context:
        yield context


def test_from_the_page_that_explains_to_a_green_tick_and_the_pages(
    stranger: BrowserContext, trusting: BrowserContext, lan: ServedLan, until: Callable[..., Any]
) -> None:
    page = stranger.new_page()
    page.goto(lan.page)
    until(page, "document.querySelector('.check').dataset.state === 'not-yet'")
    assert page.locator("button[aria-pressed=true]").inner_text() == "Linux"
    for button in page.locator(".devices button").all():
        button.click()
        assert page.locator(".steps li").count() >= 2
    page.get_by_role("button", name="iPad or iPhone").click()
    assert page.locator(".steps svg").count() == 4
    with page.expect_download() as profile:
        page.get_by_role("link", name="Load the profile").click()
    assert profile.value.suggested_filename == "bodydrive.mobileconfig"
    assert page.evaluate("[...document.querySelectorAll('button, .go')].every((e) => e.offsetHeight >= 44)")
    with pytest.raises(Error, match="ERR_CERT_AUTHORITY_INVALID"):
        page.goto(lan.facts["link"])  # this page stays open: see `tablet`

    page = trusting.new_page()
    for host in (HOSTS[0], NAME):
        page.goto(lan.page.replace(HOSTS[0], host))
        until(page, "document.querySelector('.check').dataset.state === 'trusted'")
        assert page.locator(".steps").is_hidden()
        page.get_by_role("link", name="Go on").click()
        page.wait_for_url(f"https://{host}:{lan.port}/**")
        assert page.evaluate("isSecureContext") is True
    page.close()


def test_a_first_owner_drives_the_pages_over_https(
    trusting: BrowserContext, lan: ServedLan, until: Callable[..., Any]
) -> None:
    page = trusting.new_page()
    page.goto(f"https://{HOSTS[1]}:{lan.port}/")
    code = {"code": lan.code, **OWNER}
    made = page.evaluate(
        "async (body) => (await fetch('/api/v1/auth/setup', {method: 'POST', "
        "headers: {'Content-Type': 'application/json'}, body: JSON.stringify(body)})).status",
        code,
    )
    assert made == 200
    sockets: list[str] = []
    page.on("websocket", lambda opened: sockets.append(opened.url))
    page.reload()
    until(page, "document.querySelector('nav') !== null")
    while not any("/api/v1/" in url for url in sockets):
        page.wait_for_timeout(50)
    assert all(url.startswith(f"wss://{HOSTS[1]}:{lan.port}/") for url in sockets)
    cookies = {cookie["name"]: cookie for cookie in trusting.cookies()}
    assert cookies["__Host-bodydrive_sign_in"]["secure"]
    devtools = trusting.new_cdp_session(page)
    manifest = devtools.send("Page.getAppManifest")
    assert manifest["errors"] == []
    assert manifest["url"].endswith("/bodydrive.webmanifest")
    assert devtools.send("Page.getInstallabilityErrors") == {"installabilityErrors": []}
    assert page.evaluate("'wakeLock' in navigator && 'mediaDevices' in navigator") is True
    page.close()


@pytest.mark.parametrize(
    ("name", "error"), [(NAME, "ERR_EMPTY_RESPONSE"), (FOREIGN, "ERR_CERT_INVALID|ERR_CERT_NAME_CONSTRAINT_VIOLATION")]
)
def test_chromium_trusts_the_root_for_this_machine_and_not_for_the_internet(
    trusting: BrowserContext, lan: ServedLan, tmp_path: Path, name: str, error: str
) -> None:
    """Somebody has the intermediate's key: their certificate of this machine is trusted, that of a bank is not."""
    certificate, mark, key = (lan.state / "authority" / "intermediate.pem").read_bytes().partition(KEY)
    intermediate = read_identity(certificate, mark + key)
    serving = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    leaf = make_leaf(intermediate, [x509.DNSName(name)], utc_now())
    (tmp_path / "leaf.pem").write_bytes(leaf.certificate_pem + certificate + leaf.key_pem)
    serving.load_cert_chain(tmp_path / "leaf.pem")
    page = trusting.new_page()
    with socket.create_server((HOSTS[1], 0)) as listening:

        def answer_nothing() -> None:
            while True:
                try:
                    with serving.wrap_socket(listening.accept()[0], server_side=True) as connection:
                        connection.recv(1000)
                except ssl.SSLError:
                    continue
                except OSError:
                    return

        thread = threading.Thread(target=answer_nothing)
        thread.start()
        try:
            with pytest.raises(Error, match=error):
                page.goto(f"https://{name}:{listening.getsockname()[1]}/")
        finally:
            listening.shutdown(socket.SHUT_RDWR)
            thread.join()  # the page stays open: see `tablet`


def test_a_replaced_authority_is_said(stranger: BrowserContext, lan: ServedLan, until: Callable[..., Any]) -> None:
    page = stranger.new_page()
    page.goto(lan.page)
    page.evaluate("localStorage.setItem('bodydrive_trusted', 'another')")
    page.reload()
    until(page, "document.querySelector('.check').dataset.state === 'replaced'")
    page.evaluate("localStorage.clear()")
    page.close()


def test_a_wrong_clock_is_said(stranger: BrowserContext, lan: ServedLan, until: Callable[..., Any]) -> None:
    page = stranger.new_page()
    page.add_init_script(WRONG_CLOCK)
    page.goto(lan.page)
    until(page, "document.querySelector('.check').dataset.state === 'clock'")
    said = page.locator(".check").inner_text()
    assert re.search(r"This device shows (Dec 31, 2000|Jan 1, 2001), \d\d:\d\d, the machine shows", said)
    assert "set date and time by itself" in said
    page.close()
