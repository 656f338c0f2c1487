"""What the clinic's authority makes: verified by openssl, and by a client of Python's ssl module."""

import datetime as dt
import ipaddress
import socket
import ssl
import subprocess
import threading
from pathlib import Path

import pytest
from cryptography import x509
from hypothesis import given, settings
from hypothesis import strategies as st

from app.host.authority import (
    Identity,
    certified,
    make_intermediate,
    make_leaf,
    make_root,
    read_identity,
    signed_by,
    subjects_of,
)
from app.host.certificate_times import needs_renewal
from app.host.machine import Machine, certifiable, this_machine

NOW = dt.datetime(2026, 5, 1, 12, tzinfo=dt.UTC)
MACHINE = Machine(
    "clinic-pc",
    tuple(map(ipaddress.ip_address, ("192.168.7.5", "fd00::5", "127.0.0.1", "::1"))),
    tuple(map(ipaddress.ip_network, ("192.168.7.0/24", "127.0.0.0/8"))),
)
PUBLIC = Machine("pc", (ipaddress.ip_address("198.51.100.7"),), (ipaddress.ip_network("198.51.100.0/24"),))
ROOT = make_root(MACHINE, NOW)
INTERMEDIATE = make_intermediate(ROOT, NOW)


def verdict(folder: Path, leaf: Identity, intermediate: Identity, *options: str, root: Identity = ROOT) -> str:
    """Return what `openssl verify` says of a chain."""
    files = {"leaf": leaf, "intermediate": intermediate, "root": root}
    for name, identity in files.items():
        (folder / name).write_bytes(identity.certificate_pem)
    words = ["openssl", "verify", "-x509_strict", "-purpose", "sslserver", "-attime", str(int(NOW.timestamp()))]
    chain = ["-CAfile", str(folder / "root"), "-untrusted", str(folder / "intermediate"), str(folder / "leaf")]
    said = subprocess.run([*words, *options, *chain], capture_output=True, text=True, check=False)
    return (said.stdout + said.stderr).strip()


@pytest.mark.parametrize(
    ("option", "name", "good"),
    [
        ("-verify_hostname", "clinic-pc", True),
        ("-verify_hostname", "clinic-pc.local", True),
        ("-verify_hostname", "localhost", True),
        ("-verify_ip", "192.168.7.5", True),
        ("-verify_ip", "fd00::5", True),
        ("-verify_ip", "192.168.7.6", False),
        ("-verify_hostname", "clinic-pd", False),
    ],
)
def test_openssl_verifies_the_chain_for_the_machines_names_and_addresses(
    tmp_path: Path, option: str, name: str, good: bool
) -> None:
    leaf = make_leaf(INTERMEDIATE, subjects_of(MACHINE, ROOT.certificate), NOW)
    assert verdict(tmp_path, leaf, INTERMEDIATE, option, name).endswith(": OK") == good


@pytest.mark.parametrize(
    "foreign",
    [x509.DNSName("bank.example"), x509.DNSName("clinic-pc.example"), x509.IPAddress(ipaddress.ip_address("8.8.8.8"))],
)
def test_the_root_cannot_vouch_for_the_internet(tmp_path: Path, foreign: x509.GeneralName) -> None:
    leaf = make_leaf(INTERMEDIATE, [foreign], NOW)
    assert "permitted subtree violation" in verdict(tmp_path, leaf, INTERMEDIATE)


def test_the_intermediate_makes_no_further_authority(tmp_path: Path) -> None:
    below = make_intermediate(INTERMEDIATE, NOW - dt.timedelta(days=1))  # of another name: its own name counts as one
    leaf = make_leaf(below, subjects_of(MACHINE, ROOT.certificate), NOW)
    both = Identity(below.certificate, below.key)
    (tmp_path / "more").write_bytes(INTERMEDIATE.certificate_pem)
    assert "path length constraint exceeded" in verdict(tmp_path, leaf, both, "-untrusted", str(tmp_path / "more"))


def test_the_lifetimes() -> None:
    leaf = make_leaf(INTERMEDIATE, subjects_of(MACHINE, ROOT.certificate), NOW).certificate
    assert leaf.not_valid_after_utc - leaf.not_valid_before_utc <= dt.timedelta(days=397)
    late = NOW + dt.timedelta(days=1090)
    last = make_leaf(INTERMEDIATE, subjects_of(MACHINE, ROOT.certificate), late).certificate
    assert last.not_valid_after_utc == INTERMEDIATE.certificate.not_valid_after_utc


@given(st.floats(-2, 2))
def test_a_certificate_is_renewed_before_a_third_of_its_time_is_left(share: float) -> None:
    leaf = make_leaf(INTERMEDIATE, subjects_of(MACHINE, ROOT.certificate), NOW).certificate
    whole = leaf.not_valid_after_utc - leaf.not_valid_before_utc
    at = leaf.not_valid_before_utc + share * whole
    assert needs_renewal(leaf, at) == (at < leaf.not_valid_before_utc or at > leaf.not_valid_before_utc + whole * 2 / 3)


@given(st.text(max_size=300) | st.from_regex(r"[a-zA-Z0-9.-]{1,80}", fullmatch=True))
@settings(max_examples=100)
def test_any_name_of_a_machine_makes_a_certificate(name: str) -> None:
    machine = Machine(certifiable(name), MACHINE.addresses, MACHINE.networks)
    root = make_root(machine, NOW)
    subjects = subjects_of(machine, root.certificate)
    assert {each.value for each in subjects if isinstance(each, x509.DNSName)} == set(machine.names)
    leaf = make_leaf(make_intermediate(root, NOW), subjects, NOW)
    assert certified(leaf.certificate) == set(subjects)


@given(st.ip_addresses())
def test_only_addresses_in_the_roots_networks_are_certified(address: ipaddress.IPv4Address) -> None:
    machine = Machine("clinic-pc", (address,), ())
    permitted = ROOT.certificate.extensions.get_extension_for_class(x509.NameConstraints).value.permitted_subtrees or []
    networks = [ipaddress.ip_network(str(each.value)) for each in permitted if isinstance(each, x509.IPAddress)]
    inside = any(address in network for network in networks)
    assert (x509.IPAddress(address) in subjects_of(machine, ROOT.certificate)) == inside


def test_a_machine_with_a_public_address_gets_its_network_into_the_root(tmp_path: Path) -> None:
    root = make_root(PUBLIC, NOW)
    intermediate = make_intermediate(root, NOW)
    leaf = make_leaf(intermediate, subjects_of(PUBLIC, root.certificate), NOW)
    assert verdict(tmp_path, leaf, intermediate, "-verify_ip", "198.51.100.7", root=root).endswith(": OK")


def test_a_key_of_another_certificate_is_refused() -> None:
    assert read_identity(ROOT.certificate_pem, ROOT.key_pem).certificate == ROOT.certificate
    with pytest.raises(ValueError, match="another"):
        read_identity(ROOT.certificate_pem, INTERMEDIATE.key_pem)
    assert not signed_by(ROOT.certificate, INTERMEDIATE.certificate)


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost", "clinic-pc.local"])
def test_a_client_of_pythons_ssl_trusts_the_chain(tmp_path: Path, name: str) -> None:
    now = dt.datetime.now(dt.UTC)
    root = make_root(MACHINE, now)
    intermediate = make_intermediate(root, now)
    leaf = make_leaf(intermediate, subjects_of(MACHINE, root.certificate), now)
    (tmp_path / "leaf.pem").write_bytes(leaf.certificate_pem + intermediate.certificate_pem + leaf.key_pem)
    serving = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    serving.load_cert_chain(tmp_path / "leaf.pem")
    trusting = ssl.create_default_context(cadata=root.certificate_pem.decode())
    with socket.create_server(("127.0.0.1", 0)) as listening:

        def answer() -> None:
            with serving.wrap_socket(listening.accept()[0], server_side=True) as connection:
                connection.sendall(b"here")

        thread = threading.Thread(target=answer)
        thread.start()
        plain = socket.create_connection(listening.getsockname())
        with plain, trusting.wrap_socket(plain, server_hostname=name) as connection:
            assert connection.recv(10) == b"here"
        thread.join()


def test_this_machine_has_its_loopback_address() -> None:
    found = this_machine()
    assert ipaddress.ip_address("127.0.0.1") in found.addresses
    assert not any(address.version == 6 and address.is_link_local for address in found.addresses)
    second = ipaddress.ip_address("127.0.0.2")
    assert this_machine((second,)).addresses[0] == second
