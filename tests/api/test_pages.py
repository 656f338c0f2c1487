"""The pages' headers, and uploads."""

import io
from typing import Any

import pytest

from app.api.routes.signal_uploads import harmless_name


def test_nothing_is_fetched_from_elsewhere(clinic: Any) -> None:
    policy = clinic.client.get("/api/v1/auth/me").headers["content-security-policy"]
    assert "script-src 'self';" in policy
    assert "frame-ancestors 'self'" in policy
    assert "ws://127.0.0.1:8080" in policy
    assert clinic.client.get("/docs").status_code == 404


def test_patients_are_kept_by_no_cache(signed_in: Any) -> None:
    headers = signed_in("GET", "/patients").headers
    assert (headers["cache-control"], headers["x-content-type-options"]) == ("no-store", "nosniff")


def test_an_address_that_is_nothing_is_said_so(signed_in: Any) -> None:
    for method, path in (("GET", "/nothing"), ("PATCH", "/patients")):
        answer = signed_in(method, path)
        assert answer.status_code in {404, 405}
        assert answer.json()["detail"].startswith(("There is nothing", "This cannot"))


@pytest.mark.parametrize(
    ("given", "kept"),
    [
        ("../../etc/passwd", "passwd"),
        ("C:\\Users\\x\\Drive 1.CSV", "Drive-1.csv"),
        (".hidden.parquet", "hidden.parquet"),
        ("..", "file"),
        ("", "file"),
        ("a\x00b.csv", "a-b.csv"),
        ("<img src=x>.csv", "img-src-x.csv"),
    ],
)
def test_names_of_brought_files_are_harmless(given: str, kept: str) -> None:
    assert harmless_name(given) == kept


def upload(clinic: Any, name: str, content: bytes) -> Any:
    return clinic("POST", "/equipment/files", files={"file": (name, io.BytesIO(content), "text/csv")})


def test_files_are_taken_in_by_type_and_content(signed_in: Any) -> None:
    assert upload(signed_in, "run.exe", b"t,a\n0,1\n").status_code == 415
    for name, content in (("run.csv", b""), ("run.csv", b"a,b\n0,1\n"), ("run.parquet", b"PAR1 nothing PAR1")):
        assert upload(signed_in, name, content).status_code == 422
    assert signed_in.good("GET", "/equipment")["files"] == []
    assert upload(signed_in, "../walk.csv", b"t,a,b\n0,1,2\n").status_code == 201
    assert upload(signed_in, "body.csv", b"t,left_elbow_x,left_elbow_y,left_elbow_z\n0,1,2,3\n").status_code == 201
    files = {file["name"]: file["kind"] for file in signed_in.good("GET", "/equipment")["files"]}
    assert files == {"walk.csv": "signals", "body.csv": "body"}


def test_what_is_too_large_is_refused_before_it_is_read(signed_in: Any) -> None:
    assert signed_in("POST", "/patients", content=b"x" * 2_000_001).status_code == 413

    def pieces() -> Any:
        for _ in range(50):
            yield b"x" * 100_000

    assert signed_in("POST", "/patients", content=pieces()).status_code == 413


def test_the_shirt_is_chosen_by_what_is_here(signed_in: Any) -> None:
    equipment = signed_in.good("GET", "/equipment")
    assert (equipment["shirt"]["kind"], equipment["status"]["control"]) == ("simulator", "alive")
    missing = {"kind": "replay", "file": "nowhere.csv", "loop": True}
    assert "Add a file" in signed_in.refused(404, "PUT", "/equipment/shirt", json=missing)
    assert upload(signed_in, "walk.csv", b"t,a\n0,1\n").status_code == 201
    chosen = signed_in.good("PUT", "/equipment/shirt", json={"kind": "replay", "file": "walk.csv", "loop": True})
    assert (chosen["shirt"]["file"], chosen["body"]) == ("walk.csv", None)
    sent = [fields for do, fields in signed_in.process.calls if do == "shirt"][-1]
    assert sent["config"]["file"].endswith("/files/walk.csv")
    assert signed_in("PUT", "/equipment/body", json={"kind": "visitor"}).status_code == 409
    assert signed_in("PUT", "/equipment/shirt", json={"kind": "telepathy"}).status_code == 422
    channels = ["left_elbow_1"]
    assert signed_in.good("PUT", "/equipment/unused", json={"channels": channels})["unused"] == channels
    assert signed_in("PUT", "/equipment/unused", json={"channels": ["no_such"]}).status_code == 404
