"""Over https every cookie is marked for encrypted connections alone, in its name too, and origins must be https."""

from http.cookies import SimpleCookie
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.people_of_clinic import OWNER
from starlette.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

HTTPS = "https://127.0.0.1:8443"


def over(clinic: Clinic, base: str) -> TestClient:
    """Return a browser of the running application at another address."""
    browser = TestClient(clinic.client.app, base_url=base, client=("127.0.0.1", 50_001), headers={"Origin": base})
    browser.portal = clinic.client.portal  # one event loop, that of the application
    return browser


def cookies_of(answer: Any) -> dict[str, Any]:
    return {
        name: morsel for line in answer.headers.get_list("set-cookie") for name, morsel in SimpleCookie(line).items()
    }


def test_over_https_the_names_say_that_only_https_may_set_them(real: Clinic) -> None:
    browser = over(real, HTTPS)
    answer = browser.post("/api/v1/auth/setup", json=OWNER)
    assert answer.status_code == 200
    made = cookies_of(answer)
    assert set(made) == {"__Host-bodydrive_sign_in", "__Secure-bodydrive_browser_1"}
    assert all(morsel["secure"] and morsel["httponly"] for morsel in made.values())
    host = made["__Host-bodydrive_sign_in"]
    assert (host["path"], host["domain"], host["samesite"]) == ("/", "", "lax")
    assert made["__Secure-bodydrive_browser_1"]["path"] == "/api/v1/auth"
    assert browser.get("/api/v1/auth/me").json()["name"] == "Ada"
    deleted = cookies_of(browser.post("/api/v1/auth/sign-out"))["__Host-bodydrive_sign_in"]
    assert (deleted["secure"], deleted["max-age"]) == (True, "0")
    assert browser.get("/api/v1/auth/me").json()["name"] is None


def test_a_cookie_without_the_prefix_opens_nothing_over_https(real: Clinic) -> None:
    real.good("POST", "/auth/setup", json=OWNER)
    token = real.client.cookies["bodydrive_sign_in"]
    browser = over(real, HTTPS)
    plain = {"Cookie": f"__Host-bodydrive_sign_in={token}"}
    assert browser.get("/api/v1/patients", headers={"Cookie": f"bodydrive_sign_in={token}"}).status_code == 401
    assert browser.get("/api/v1/patients", headers=plain).status_code == 200
    real.client.cookies.clear()
    assert real("GET", "/patients", headers=plain).status_code == 401


def test_a_page_loaded_over_http_changes_nothing_over_https(real: Clinic) -> None:
    browser = over(real, HTTPS)
    http = {"Origin": HTTPS.replace("https", "http")}
    assert browser.post("/api/v1/auth/setup", json=OWNER, headers=http).status_code == 403
    assert browser.post("/api/v1/auth/setup", json=OWNER).status_code == 200
    url = f"{HTTPS.replace('https', 'wss')}/api/v1/live"
    with browser.websocket_connect(url, headers={"Origin": HTTPS}) as socket:
        assert socket.receive_json()
    with pytest.raises(WebSocketDisconnect), browser.websocket_connect(url, headers=http) as socket:
        socket.receive_json()


def test_over_https_the_page_may_open_encrypted_sockets_only(real: Clinic) -> None:
    policy = over(real, HTTPS).get("/").headers["content-security-policy"]
    assert "connect-src 'self' wss://127.0.0.1:8443;" in policy
    assert "ws://127.0.0.1:8080;" in real.client.get("/").headers["content-security-policy"]
