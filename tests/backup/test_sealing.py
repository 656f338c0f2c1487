"""Sealing with a passphrase: what is read back, and that no cut and no change is unnoticed."""

import io

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.backup import sealing
from app.backup.sealing import Secret, secret_of
from app.refusals import Refusal

SECRET = Secret(b"s" * 16, b"k" * 32)


def test_a_passphrase_makes_the_same_key_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sealing, "COST", {"n": 2, "r": 1, "p": 1})
    first = secret_of("a long passphrase")
    assert secret_of("a long passphrase", first.salt) == first
    assert secret_of("another passphrase", first.salt) != first
    assert first.key.hex() not in repr(first)


@given(st.binary(max_size=300), st.integers(0, 400))
def test_sealed_bytes_are_read_back_and_no_cut_is_unnoticed(content: bytes, at: int) -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sealing, "CHUNK", 64)
        out = io.BytesIO()
        writer = sealing.SealingWriter(out, SECRET)
        writer.write(content)
        writer.end()
        sealed = out.getvalue()
        assert sealing.OpeningReader(io.BytesIO(sealed), SECRET).read(1000) == content
        assert content not in sealed[56:] or len(content) < 8
        if at < len(sealed):
            with pytest.raises(Refusal):
                sealing.OpeningReader(io.BytesIO(sealed[:at]), SECRET).read(1000)
            changed = sealed[:at] + bytes([sealed[at] ^ 4]) + sealed[at + 1 :]
            if not 8 <= at < 24:  # the passphrase's salt, from which the key is made
                with pytest.raises(Refusal):
                    sealing.OpeningReader(io.BytesIO(changed), SECRET).read(1000)
