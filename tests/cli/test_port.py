"""The port of a clinic: refused in a sentence when it cannot be had, and no answer waits for a confirmation."""

import socket
from ipaddress import ip_network

import pytest

from app.cli.errors import InputError
from app.cli.port import bind, link_to, proxy_network, public_name


def test_no_part_of_an_answer_waits_for_the_browser_to_confirm_another() -> None:
    with bind("127.0.0.1", 0) as listening, socket.create_connection(listening.getsockname()):
        connection, _ = listening.accept()
        with connection:
            assert connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY)


def test_a_busy_port_is_refused_with_what_to_do() -> None:
    with bind("127.0.0.1", 0) as listening:
        port = listening.getsockname()[1]
        with pytest.raises(InputError, match=rf"Port {port} of 127.0.0.1 is busy: .* --port"):
            bind("127.0.0.1", port)


@pytest.mark.parametrize("host", ["", " ", "nowhere.invalid", "192.0.2.1", "a" * 300])
def test_an_address_of_another_machine_is_refused(host: str) -> None:
    with pytest.raises(InputError, match="is no address of this machine"):
        bind(host, 0)


@pytest.mark.parametrize(
    ("host", "link"),
    [
        ("127.0.0.1", "http://127.0.0.1:8080/"),
        ("0.0.0.0", "http://127.0.0.1:8080/"),
        ("::1", "http://[::1]:8080/"),
        ("localhost", "http://localhost:8080/"),
    ],
)
def test_the_link_can_be_opened_on_this_machine(host: str, link: str) -> None:
    assert link_to(host, 8080) == link


def test_the_proxy_is_an_address_or_a_small_network() -> None:
    assert proxy_network("127.0.0.1") == ip_network("127.0.0.1")
    assert proxy_network("10.1.2.3/24") == ip_network("10.1.2.0/24")
    for wrong in ("", "proxy", "0.0.0.0/0", "::/0", "10.0.0.0/8", "127.0.0.1:80"):
        with pytest.raises(InputError, match="--behind-proxy"):
            proxy_network(wrong)


@pytest.mark.parametrize("name", ["clinic.example.org", "clinic.example.org:8443", "10.1.2.3", "[fd00::7]:8443"])
def test_a_name_of_the_proxy_is_kept(name: str) -> None:
    assert public_name(name.upper()) == name


@pytest.mark.parametrize(
    "name", ["", "https://clinic.example.org", "a b", "clinic/x", "me@clinic", "clinic:99999", "[::1"]
)
def test_another_text_is_no_name(name: str) -> None:
    with pytest.raises(InputError, match="--name"):
        public_name(name)
