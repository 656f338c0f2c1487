"""The certificate in use: made once, renewed, following the machine; damage, replacement and wrong clocks are said."""

import contextlib
import datetime as dt
import ipaddress
import ssl
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from cryptography import x509
from cryptography.hazmat.primitives import serialization

from app.host.authority import make_intermediate, make_leaf, make_root
from app.host.certificate import KEY, MADE, REPLACED, LocalCertificate, OwnCertificate
from app.host.machine import Machine
from app.refusals import Refusal

START = dt.datetime(2026, 5, 1, 12, tzinfo=dt.UTC)


def machine_at(*addresses: str) -> Machine:
    return Machine("clinic-pc", tuple(map(ipaddress.ip_address, addresses)), ())


class Place:
    """A machine whose clock and addresses a test sets."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.now, self.machine = folder / "authority", START, machine_at("192.168.1.5", "127.0.0.1")

    def open(self) -> LocalCertificate:
        return LocalCertificate(self.folder, lambda: self.machine, lambda: self.now)

    def served(self) -> x509.Certificate:
        return x509.load_pem_x509_certificate((self.folder / "machine.pem").read_bytes())


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path)


def test_it_is_made_once_and_only_its_owner_reads_the_keys(place: Place) -> None:
    first = place.open()
    assert first.refresh() == [MADE]
    again = place.open()
    assert again.refresh() == []
    assert again.trust == first.trust
    files = list(place.folder.iterdir())
    assert {file.name for file in files} == {"root.pem", "intermediate.pem", "machine.pem"}
    assert {stat.S_IMODE(file.stat().st_mode) for file in files} == {0o600}


def handshake(context: ssl.SSLContext) -> x509.Certificate:
    """Return the certificate that a new connection gets."""
    to_server, to_client = ssl.MemoryBIO(), ssl.MemoryBIO()
    asking = ssl.create_default_context()
    asking.check_hostname, asking.verify_mode = False, ssl.CERT_NONE
    client = asking.wrap_bio(to_client, to_server)
    server = context.wrap_bio(to_server, to_client, server_side=True)
    for side in (client, server, client, server):
        with contextlib.suppress(ssl.SSLWantReadError):
            side.do_handshake()
    return x509.load_der_x509_certificate(client.getpeercert(binary_form=True) or b"")


def test_it_follows_the_addresses_without_a_restart(place: Place) -> None:
    certificate = place.open()
    certificate.refresh()
    before = handshake(certificate.context)
    assert before == place.served()
    place.machine = machine_at("10.0.0.9", "127.0.0.1")
    assert certificate.refresh() == []
    assert handshake(certificate.context) == place.served() != before
    assert certificate.trust.addresses == ("10.0.0.9", "127.0.0.1")
    place.machine = machine_at("10.0.0.9", "8.8.8.8")
    (outside,) = certificate.refresh()
    assert "8.8.8.8" in str(outside)
    assert "10.0.0.9" not in str(outside)
    assert certificate.trust.addresses == ("10.0.0.9",)


def test_it_renews_itself_while_the_program_runs_and_at_its_start(place: Place) -> None:
    certificate = place.open()
    before = place.served()
    place.now = START + dt.timedelta(days=250)
    certificate.refresh()
    assert place.served() == before
    place.now = START + dt.timedelta(days=270)
    certificate.refresh()
    assert place.served().not_valid_after_utc > place.now + dt.timedelta(days=390)
    assert certificate.trust.end == place.served().not_valid_after_utc
    place.now = START + dt.timedelta(days=2000)  # everything but the root has ended
    assert place.open().trust.end > place.now


def test_a_file_that_can_be_made_anew_is(place: Place) -> None:
    place.open()
    for name in ("intermediate.pem", "machine.pem"):
        (place.folder / name).write_bytes(b"damaged")
        assert place.open().trust.addresses == ("192.168.1.5", "127.0.0.1")


@pytest.mark.parametrize("damage", [lambda text: text[:-200], lambda _text: b"", lambda text: text.partition(KEY)[0]])
def test_a_damaged_authority_is_one_sentence_and_stays_as_it_is(place: Place, damage: Callable[[bytes], bytes]) -> None:
    place.open()
    root = place.folder / "root.pem"
    root.write_bytes(damage(root.read_bytes()))
    before = root.read_bytes()
    with pytest.raises(Refusal, match=r"root.pem is damaged: .*backup"):
        place.open()
    assert root.read_bytes() == before


def test_a_replaced_authority_is_said(place: Place) -> None:
    place.open()
    (place.folder / "root.pem").unlink()
    certificate = place.open()
    assert certificate.refresh() == [REPLACED]
    other = make_root(place.machine, START)
    (place.folder / "root.pem").write_bytes(other.certificate_pem + other.key_pem)
    certificate = place.open()
    assert certificate.refresh() == [REPLACED]
    root = other.certificate.public_bytes(serialization.Encoding.DER)
    assert certificate.trust.root == root


def test_a_wrong_clock_is_said_at_the_start_and_later(place: Place) -> None:
    certificate = place.open()
    certificate.refresh()
    place.now = dt.datetime(2000, 1, 1, tzinfo=dt.UTC)
    (later,) = certificate.refresh()
    assert "clock shows 2000-01-01" in str(later)
    with pytest.raises(Refusal, match="clock shows 2000-01-01"):
        place.open()
    place.now = START + dt.timedelta(days=4000)
    with pytest.raises(Refusal, match=r"ended on .* install the new authority on each tablet"):
        place.open()


def test_the_end_of_the_authority_is_announced(place: Place) -> None:
    place.open().refresh()
    place.now = START + dt.timedelta(days=3000)
    assert any("authority ends on" in str(sentence) for sentence in place.open().refresh())


def test_a_full_disk_keeps_the_old_certificate(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    certificate = place.open()
    certificate.refresh()
    before = certificate.trust

    def no_room(*_given: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("app.host.certificate.write_atomically", no_room)
    place.now = START + dt.timedelta(days=300)
    (sentence,) = certificate.refresh()
    assert "could not be renewed (No space left on device)" in str(sentence)
    assert certificate.trust == before


@pytest.fixture
def own(tmp_path: Path) -> tuple[Path, Path]:
    write_own(tmp_path, START)
    return tmp_path / "clinic.pem", tmp_path / "clinic.key"


def write_own(folder: Path, now: dt.datetime) -> None:
    intermediate = make_intermediate(make_root(machine_at("127.0.0.1"), now), now)
    leaf = make_leaf(intermediate, [x509.DNSName("Drive.Clinic.example")], now)
    (folder / "clinic.pem").write_bytes(leaf.certificate_pem + intermediate.certificate_pem)
    (folder / "clinic.key").write_bytes(leaf.key_pem)


def test_a_certificate_of_ones_own_is_read_anew_when_it_is_replaced(own: tuple[Path, Path]) -> None:
    now = [START]
    certificate = OwnCertificate(*own, lambda: now[0])
    assert isinstance(certificate.context, ssl.SSLContext)
    assert (certificate.trust.names, certificate.trust.root) == (("drive.clinic.example",), None)
    assert certificate.refresh() == []
    now[0] = START + dt.timedelta(days=390)
    assert "ends on" in str(certificate.refresh()[0])
    now[0] = START + dt.timedelta(days=398)
    assert "ended on" in str(certificate.refresh()[0])
    write_own(own[0].parent, now[0])
    assert certificate.refresh() == []
    assert certificate.trust.end > now[0]
    own[1].write_bytes(b"damaged")
    assert "belong together" in str(certificate.refresh()[0])


@pytest.mark.parametrize("days", [-30, 400])
def test_a_certificate_of_ones_own_that_is_not_valid_is_refused(own: tuple[Path, Path], days: int) -> None:
    with pytest.raises(Refusal, match="clock shows"):
        OwnCertificate(*own, lambda: START + dt.timedelta(days=days))


def test_files_that_are_no_certificate_are_refused(own: tuple[Path, Path], tmp_path: Path) -> None:
    with pytest.raises(Refusal, match="cannot be read"):
        OwnCertificate(tmp_path / "missing", own[1], lambda: START)
    with pytest.raises(Refusal, match="belong together"):
        OwnCertificate(own[1], own[0], lambda: START)
