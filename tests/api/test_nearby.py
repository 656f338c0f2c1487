"""Which requests count as coming from within the building."""

import socket

import pytest
from fastapi import FastAPI
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import HTTPConnection

from app.api.nearby import is_nearby
from app.cli.server import WebServer


def asked_from(host: str | None, **headers: str) -> HTTPConnection:
    raw = [(name.replace("_", "-").lower().encode(), value.encode()) for name, value in headers.items()]
    client = None if host is None else (host, 50_000)
    return HTTPConnection({"type": "http", "headers": raw, "client": client})


@pytest.mark.parametrize(
    "host",
    [
        *("127.0.0.1", "127.9.9.9", "10.1.2.3", "172.16.0.1", "172.31.255.255", "192.168.1.20", "169.254.7.7"),
        *("::1", "fd00::1", "fe80::1", "fe80::1%eth0", "::ffff:192.168.1.20"),
    ],
)
def test_the_networks_of_a_building_are_near(host: str) -> None:
    assert is_nearby(asked_from(host))


@pytest.mark.parametrize(
    "host",
    [
        *("8.8.8.8", "172.15.255.255", "172.32.0.0", "192.169.0.1", "0.0.0.0", "2001:db8::1", "::ffff:8.8.8.8"),
        "100.64.0.1",  # shared by whole providers, and what some tunnels use
        *("testclient", "", None),
    ],
)
def test_everything_else_is_far(host: str | None) -> None:
    assert not is_nearby(asked_from(host))


@given(st.text(max_size=40))
def test_no_text_is_an_address_by_accident(host: str) -> None:
    assert isinstance(is_nearby(asked_from(host)), bool)


@pytest.mark.parametrize("name", ["Forwarded", "Via", "X_Real_IP", "X_Forwarded_For", "X_Forwarded_Anything"])
def test_what_was_passed_on_is_far(name: str) -> None:
    assert not is_nearby(asked_from("127.0.0.1", **{name: "127.0.0.1"}))
    assert is_nearby(asked_from("127.0.0.1", User_Agent="a browser"))


def test_the_server_believes_no_header_about_who_is_connected() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listening:
        server = WebServer(FastAPI(), listening, "")
    assert server.config.proxy_headers is False
