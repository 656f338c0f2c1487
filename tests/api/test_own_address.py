"""The address of this program for another screen."""

import datetime as dt

import pytest

from app.api.own_address import own_address
from app.network import CertificateTrust, NetworkService
from app.settings import Settings

NOW = dt.datetime(2026, 5, 1, tzinfo=dt.UTC)
OWN = "https://d.clinic.example/"  # the clinic's own name, at the usual port


NAMES = ("pc", "pc.local", "localhost")


def network(*addresses: str, names: tuple[str, ...] = NAMES, port: int = 8443) -> NetworkService:
    return NetworkService(port, 8081, CertificateTrust(names, addresses, NOW, NOW, "00", b"root"))


@pytest.mark.parametrize(
    ("asked", "service", "base", "only_here"),
    [
        ("http://127.0.0.1:8080", None, "http://127.0.0.1:8080/", True),
        ("http://192.168.1.7:8080", None, "http://127.0.0.1:8080/", True),
        ("https://drive.clinic.example", None, "https://drive.clinic.example/", False),
        ("http://127.0.0.1:8080", network("10.1.2.3", "127.0.0.1"), "https://10.1.2.3:8443/", False),
        ("http://localhost:8080", network("fd00::7"), "https://[fd00::7]:8443/", False),
        ("https://pc.local:8443", network("10.1.2.3"), "https://pc.local:8443/", False),
        ("https://127.0.0.1:8443", network("10.1.2.3"), "https://10.1.2.3:8443/", False),
        ("http://127.0.0.1:8080", network(names=("*.clinic.example", "d.clinic.example"), port=443), OWN, False),
        ("http://127.0.0.1:8080", network("127.0.0.1"), "https://127.0.0.1:8443/", True),
    ],
)
def test_the_link_names_an_address_that_another_screen_can_open(
    asked: str, service: NetworkService | None, base: str, only_here: bool
) -> None:
    scheme, _, host = asked.partition("://")

    class Asked:
        headers = {"host": host}  # noqa: RUF012
        scope = {"scheme": scheme}  # noqa: RUF012

    assert own_address(Settings(network=service), Asked()) == (base, only_here)  # type: ignore[arg-type]


def test_the_page_is_named_until_the_clinic_has_a_certificate_of_its_own() -> None:
    service = network("10.1.2.3")
    assert service.page_link() == "http://10.1.2.3:8081/"
    service.trust = CertificateTrust(("d.clinic.example",), (), NOW, NOW, "00", None)
    assert service.page_link() == "https://d.clinic.example:8443/"


def test_the_host_of_a_request_is_a_name_of_the_certificate() -> None:
    settings = Settings(network=network("10.1.2.3", names=("pc", "pc.local", "*.clinic.example")))
    assert all(settings.serves(host) for host in ("pc", "pc.local", "drive.clinic.example", "10.9.9.9", "localhost"))
    assert not any(settings.serves(host) for host in ("evil.example", "a.b.clinic.example", "local", "example"))
