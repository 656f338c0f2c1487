"""Encryption with age: what is read back, that no cut and no change is unnoticed, and that age alone opens a backup."""

import functools
import io
import shutil
import subprocess
import tarfile
import threading
from pathlib import Path

import pytest
from features.backup.light_key import LIGHT, WORDS
from hypothesis import given
from hypothesis import strategies as st
from pyrage import DecryptError, decrypt, passphrase, x25519
from store.keeping.filled_clinic import two_patients

from app.features.backup.age_files import TOO_MUCH_WORK, Secret, decrypted, encrypted, new_secret, opened_secret
from app.features.backup.backup_file import HOW_TO_WORDS
from app.features.backup.service import make_backup
from app.refusals import Refusal
from app.settings import Settings
from folders import ROOT

KEY = Secret(str(x25519.Identity.generate()), "")


@functools.cache
def known_secret() -> Secret:
    """Return one key for all tests that only use it: each new one takes a second."""
    return new_secret(WORDS)


def encrypted_bytes(content: bytes) -> bytes:
    out = io.BytesIO()
    with encrypted(out, KEY) as writer:
        for at in range(0, len(content), 70_000):
            writer.write(content[at : at + 70_000])
    return out.getvalue()


def decrypted_bytes(sealed: bytes, secret: Secret = KEY) -> bytes:
    with decrypted(io.BytesIO(sealed), secret) as reader:
        return b"".join(iter(lambda: reader.read(100_000), b""))


@given(st.binary(max_size=300), st.sampled_from([0, 1, 65_536, 200_000]), st.integers(0, 10_000), st.integers(0, 7))
def test_encrypted_bytes_are_read_back_and_no_cut_or_change_is_unnoticed(
    end: bytes, zeros: int, place: int, bit: int
) -> None:
    content = bytes(zeros) + end
    sealed = encrypted_bytes(content)
    assert decrypted_bytes(sealed) == content
    at = place % len(sealed)
    for wrong in (sealed[:at], sealed[:at] + bytes([sealed[at] ^ 1 << bit]) + sealed[at + 1 :]):
        with pytest.raises(Refusal):
            decrypted_bytes(wrong)


def test_a_passphrase_opens_its_key_and_no_other_one_does() -> None:
    secret = known_secret()
    assert secret.identity not in repr(secret)
    assert secret.identity not in secret.sealed
    for each in (secret, LIGHT):
        assert opened_secret(each.sealed, WORDS) == each
    for sealed, words in ((LIGHT.sealed, "another one"), (LIGHT.sealed[:200], WORDS), ("", WORDS)):
        with pytest.raises(Refusal, match="passphrase is wrong, or the file was changed"):
            opened_secret(sealed, words)


def test_another_key_is_one_sentence() -> None:
    with pytest.raises(Refusal, match="passphrase is wrong"):
        decrypted_bytes(encrypted_bytes(b"content"), Secret(str(x25519.Identity.generate()), ""))


@pytest.mark.parametrize("size", [10, 5_000_000])
def test_an_error_of_the_disk_is_itself_and_no_thread_stays(size: int) -> None:
    class Full:
        def write(self, _part: bytes, /) -> int:
            raise OSError(28, "No space left on device")

        def read(self, _size: int, /) -> bytes:
            raise OSError(5, "Input/output error")

    with pytest.raises(OSError, match="No space"), encrypted(Full(), KEY) as writer:
        writer.write(bytes(size))
    with pytest.raises(OSError, match="Input/output"), decrypted(Full(), KEY) as reader:
        reader.read(10)
    with pytest.raises(ZeroDivisionError), encrypted(io.BytesIO(), KEY) as writer:
        writer.write(bytes(size // 0))
    with decrypted(io.BytesIO(encrypted_bytes(bytes(size))), KEY) as reader:
        assert reader.read(1) == b"\0"  # and nobody reads the rest
    assert not [one for one in threading.enumerate() if "_work" in one.name]


@pytest.fixture(scope="module", params=["file", "folder"])
def backup(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Settings]:
    """An encrypted backup, and its clinic; the file has a key as the program makes it."""
    folder = tmp_path_factory.mktemp("backup")
    settings = Settings(state=folder / "clinic")
    two_patients(settings, "Zebra", "Heron")
    target = folder / "stick"
    if request.param == "folder":
        target.mkdir()
    secret = LIGHT if request.param == "folder" else known_secret()
    report = make_backup(settings, target, secret, with_keys=False, progress=lambda *_: None)
    return (target / report.name if target.is_dir() else target), settings


def contents_of(file: Path) -> dict[str, bytes]:
    with tarfile.open(file) as tar:
        return {member.name: tar.extractfile(member).read() for member in tar}  # type: ignore[union-attr]


def require_all(settings: Settings, folder: Path) -> None:
    for file in settings.runs.rglob("*.*"):
        assert (folder / file.relative_to(settings.state)).read_bytes() == file.read_bytes()
    assert (folder / "bodydrive.sqlite").read_bytes()[:15] == b"SQLite format 3"


def opened_by_passphrase(sealed: bytes) -> bytes:
    """Return what a passphrase opens; a computer that is busy for a moment is asked again."""
    while True:
        try:
            return bytes(passphrase.decrypt(sealed, WORDS))
        except DecryptError as error:
            if TOO_MUCH_WORK not in str(error):
                raise


def test_a_computer_that_is_too_slow_is_not_called_a_wrong_passphrase(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> bytes:
        raise DecryptError("Excessive work parameter for passphrase.\nDecryption would take around 32 seconds.")

    sealed = known_secret().sealed
    monkeypatch.setattr(passphrase, "decrypt", refuse)
    with pytest.raises(Refusal, match="too slow or too busy"):
        opened_secret(sealed, WORDS)


def test_an_implementation_of_age_and_a_reader_of_tar_open_a_backup_by_themselves(
    backup: tuple[Path, Settings], tmp_path: Path
) -> None:
    """Nothing of this program is called."""
    file, settings = backup

    def unpack(archive: bytes) -> None:
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            tar.extractall(tmp_path, filter="data")

    outer = contents_of(file)
    key = opened_by_passphrase(outer["identity.age"]).decode().strip()
    identities = [x25519.Identity.from_str(key)]
    unpack(decrypt(outer["clinic.tar.age"], identities))
    if (tmp_path / "parts.txt").exists():
        for part in (tmp_path / "parts.txt").read_text().split():
            unpack(decrypt((file.parent / "parts" / part).read_bytes(), identities))
    require_all(settings, tmp_path)


@pytest.mark.skipif(not (shutil.which("age") and shutil.which("script")), reason="needs the commands age and script")
def test_the_commands_that_a_backup_names_open_it(backup: tuple[Path, Settings], tmp_path: Path) -> None:
    file, settings = backup
    lines = contents_of(file)["HOW-TO-OPEN.txt"].decode().splitlines()[2:]
    if file.parent.name != "stick":
        lines.pop()
    commands = "\n".join(lines).replace("FILE", str(file)).replace("FOLDER", str(file.parent))
    (tmp_path / "commands.sh").write_text(f"set -e -o pipefail\n{commands}\n")
    terminal = ["script", "--quiet", "--return", "--command", "bash commands.sh", "/dev/null"]
    subprocess.run(terminal, input=f"{WORDS}\n", text=True, cwd=tmp_path, check=True)
    require_all(settings, tmp_path)


def test_the_page_for_administrators_names_the_same_commands() -> None:
    page = (ROOT / "docs" / "administrators.md").read_text()
    assert HOW_TO_WORDS.partition("\n\n")[2] in page
