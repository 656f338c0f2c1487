"""The address of this program for another screen."""

import pytest

from app.api.own_address import own_address
from app.settings import Settings


@pytest.mark.parametrize(
    ("host", "asked", "base", "only_here"),
    [
        ("127.0.0.1", "127.0.0.1:8080", "http://127.0.0.1:8080/", True),
        ("::1", "[::1]:8080", "http://[::1]:8080/", True),
        ("localhost", "localhost:8080", "http://localhost:8080/", True),
        ("192.168.1.5", "192.168.1.5:8080", "http://192.168.1.5:8080/", False),
        ("0.0.0.0", "192.168.1.7:8080", "http://192.168.1.7:8080/", False),
        ("0.0.0.0", "127.0.0.1:8080", "http://10.1.2.3:8080/", False),
        ("::", "[::1]:8080", "http://[fd00::7]:8080/", False),
        ("clinic.local", "localhost:8080", "http://clinic.local:8080/", False),
        ("127.0.0.1", "192.168.1.7:8080", "http://127.0.0.1:8080/", True),
    ],
)
def test_the_link_names_an_address_that_another_screen_can_open(
    host: str, asked: str, base: str, only_here: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = {2: "10.1.2.3", 10: "fd00::7"}
    monkeypatch.setattr("app.api.own_address.address_on_network", lambda family: found[int(family)])

    class Asked:
        headers = {"host": asked}  # noqa: RUF012
        url = type("Url", (), {"scheme": "http"})

    assert own_address(Settings(host=host), Asked()) == (base, only_here)  # type: ignore[arg-type]


def test_a_machine_on_no_network_is_only_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.api.own_address.address_on_network", lambda _family: None)

    class Asked:
        headers = {"host": "127.0.0.1:8080"}  # noqa: RUF012
        url = type("Url", (), {"scheme": "http"})

    assert own_address(Settings(host="0.0.0.0"), Asked()).only_here is True  # type: ignore[arg-type]
