"""The port of a clinic: refused in a sentence when it cannot be had, and no answer waits for a confirmation."""

import socket
from ipaddress import ip_network

import pytest

from app.cli.errors import InputError
from app.cli.port import bind, bind_free, bind_here, proxy_network, public_name
from app.network import link


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


@pytest.mark.parametrize("host", ["127.0.0.1", "127.0.0.2", "localhost", "::1"])
def test_an_address_of_this_machine_alone_needs_no_https(host: str) -> None:
    with bind_here(host, 0) as listening:
        assert listening.getsockname()[1] > 0


@pytest.mark.parametrize("host", ["0.0.0.0", "::"])
def test_without_https_no_other_machine_is_served(host: str) -> None:
    with pytest.raises(InputError, match=r"could read and change .* 'bodydrive serve --lan'"):
        bind_here(host, 0)


def test_the_first_port_that_is_free_on_all_addresses_is_bound() -> None:
    with bind("127.0.0.2", 0) as taken, bind("127.0.0.3", 0) as other:
        busy = taken.getsockname()[1]
        bound = bind_free(["127.0.0.1", "127.0.0.2"], (busy, 0))
        ports = {listening.getsockname()[1] for listening in bound}
        for listening in bound:
            listening.close()
        assert len(ports) == 1
        assert busy not in ports
        with pytest.raises(InputError, match="is busy"):
            bind_free(["127.0.0.3"], (other.getsockname()[1],))
        with socket.create_server(("127.0.0.1", busy)):  # what was bound before the busy one is free again
            pass


@pytest.mark.parametrize(
    ("scheme", "host", "port", "shown"),
    [
        ("http", "127.0.0.1", 8080, "http://127.0.0.1:8080/"),
        ("http", "192.168.1.5", 80, "http://192.168.1.5/"),
        ("https", "::1", 443, "https://[::1]/"),
        ("https", "pc.local", 80, "https://pc.local:80/"),
    ],
)
def test_the_link_leaves_out_the_usual_port(scheme: str, host: str, port: int, shown: str) -> None:
    assert link(scheme, host, port) == shown


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
