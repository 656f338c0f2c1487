"""The headers of the 3D view's page."""

import pytest

from app.api.response_headers import view_headers


@pytest.mark.parametrize("host", ["evil.example; script-src *", "a b", "", "x\r\ny", "*", "a/b"])
def test_a_strange_host_does_not_get_into_the_policy(host):
    assert "connect-src 'self' blob: data:" in view_headers(host, "http")["Content-Security-Policy"]


def test_under_tls_the_socket_is_a_safe_one():
    assert "wss://clinic.local:8443" in view_headers("clinic.local:8443", "https")["Content-Security-Policy"]
