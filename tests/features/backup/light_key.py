"""A key of backups that its passphrase opens at once; one that the program makes takes a second each time."""

import pytest

from app.features.backup import age_files, night_secret
from app.features.backup.age_files import Secret

WORDS = "a quiet blue heron"
# It is encrypted with a work factor of 10, where new_secret() takes a second's.
LIGHT = Secret(
    "AGE-SECRET-KEY-1HSQXSMNF00LD4ANZW6RA30MFAAQ404QVE4R5EQQ26Y9L8DSTDMYQ2900NR",
    """-----BEGIN AGE ENCRYPTED FILE-----
YWdlLWVuY3J5cHRpb24ub3JnL3YxCi0+IHNjcnlwdCBicTcvUFN2d0diQ3h4SGJz
Y21Rc293IDEwClUwdGUzeFZWWE5valBwMnZDOFpkK1Jyclpzalk2aEpqRmw3T0l4
cTdySDQKLS0tIHFmcHpWTVhxY3M3VGc5YVFiYTB5QTk1VG9jbEgzV2hXWjdIcjY4
V3ljY0kKmivTrYq0ehGLjDazS5tqhfCjVw1tgroYrw1bqefj1drs2IbjWL/wB1m0
zS1MKoHMQg5Nz4HN/RiAIYCbpyBzlqXswAq0bo2DX1xPyq5D+cOv2sm+Tl1Y8YBI
JW5XUO7JqlsMPLR7t2HIcVM=
-----END AGE ENCRYPTED FILE-----
""",
)


def make_light_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let a backup whose passphrase is WORDS have this key; test_age_files.py opens one that the program made."""

    def light_secret(passphrase: str) -> Secret:
        assert passphrase == WORDS
        return LIGHT

    for module in (age_files, night_secret):
        monkeypatch.setattr(module, "new_secret", light_secret)
