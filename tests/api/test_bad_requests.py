"""Malformed and hostile requests are refused in one sentence, and nothing is lost."""

import asyncio
import io
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from api.fake_clinic import sentence_of
from api.fake_process import LAYOUT
from api.pairing import closing

from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.trial import TrialFlow

LONG = "k" * 100_000


def test_an_id_that_no_database_holds_is_refused(signed_in: Any) -> None:
    for number in ("9223372036854775808", "99999999999999999999999", "-1", "NaN"):
        signed_in.refused(422, "DELETE", f"/patients/{number}")
        signed_in.refused(422, "POST", f"/patients/{number}/restore")


def test_a_body_that_cannot_be_taken_apart(signed_in: Any) -> None:
    for content, kind, status in (
        (b"\xff\xfe\x00", "application/json", 422),
        (b"[" * 100_000, "application/json", 422),
        (b'{"code": "P-1", "pseudonym": "Heron", "' + LONG.encode() + b'": 1}', "application/json", 422),
        (b'{"code": "P-1", "pseudonym": "Heron"}', "text/plain", 415),
    ):
        signed_in.refused(status, "POST", "/patients", content=content, headers={"Content-Type": kind})
    assert signed_in.good("GET", "/patients") == []


def test_names_without_end_are_not_said_back(signed_in: Any) -> None:
    assert "must be one of 'simulator'" in signed_in.refused(422, "PUT", "/equipment/shirt", json={"kind": LONG})
    assert "'kind' is missing" in signed_in.refused(422, "PUT", "/equipment/shirt", json={})
    signed_in.refused(422, "GET", "/floorplans/" + LONG[:5000])
    for name in (LONG[:4000], "..", "../clinic.db", "/etc/passwd"):
        signed_in.refused(404, "PUT", "/equipment/shirt", json={"kind": "replay", "file": name})


def test_an_error_of_ours_is_a_sentence_without_a_word_of_the_inside(
    signed_in: Any, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fails(_file: object) -> None:
        raise RuntimeError("of the inside")

    monkeypatch.setattr("app.features.log.routes.verify_log", fails)
    answer = signed_in("GET", "/log/check")
    assert "report it" in sentence_of(answer, 500)
    assert [word for word in ("of the inside", "Traceback", "RuntimeError", ".py") if word in answer.text] == []
    assert "of the inside" in caplog.text  # for whoever mends it


def test_a_form_that_is_none(signed_in: Any) -> None:
    signed_in.refused(422, "POST", "/equipment/files", data={"file": "text"})
    form = {"Content-Type": "multipart/form-data; boundary=x"}
    signed_in.refused(422, "POST", "/equipment/files", content=b"junk", headers=form)
    parts = b"".join(b'--x\r\nContent-Disposition: form-data; name="f%d"\r\n\r\n1\r\n' % i for i in range(1100))
    signed_in.refused(422, "POST", "/equipment/files", content=parts + b"--x--", headers=form)


def test_a_bad_file_does_not_take_the_place_of_a_good_one(signed_in: Any, settings: Any) -> None:
    def bring(name: str, content: bytes) -> Any:
        return signed_in("POST", "/equipment/files", files={"file": (name, io.BytesIO(content), "text/csv")})

    assert bring("walk.csv", b"t,a\n0,1\n").status_code == 201
    assert bring("walk.csv", b"junk").status_code == 422
    assert (settings.files / "walk.csv").read_bytes() == b"t,a\n0,1\n"
    (settings.files / "broken.parquet").write_bytes(b"PAR1 nothing PAR1")
    assert [file["name"] for file in signed_in.good("GET", "/equipment")["files"]] == ["walk.csv"]


@pytest.mark.parametrize(
    ("content", "status"),
    [
        (b"# logger 1.2, 50 Hz\nTime (s);A [mV]\n0,00;1,5\n0,02;1,6\n", 201),
        ("Zeit in ms\tKraft µN\n0\t1\n20\t2\n".encode("utf-16"), 201),
        (b",t,A,\n0,0.00,1,\n1,0.02,2,\n", 201),
        (b"force,A\n1,2\n", 422),
        (b"t\n1\n", 422),
        (b"\x89PNG\r\n\0", 422),
    ],
)
def test_a_recording_of_another_program_is_kept_when_it_has_times_and_channels(
    signed_in: Any, content: bytes, status: int
) -> None:
    files = {"file": ("other.csv", io.BytesIO(content), "text/csv")}
    assert signed_in("POST", "/equipment/files", files=files).status_code == status
    if status == 201:
        (file,) = signed_in.good("GET", "/equipment")["files"]
        assert (file["name"], file["kind"]) == ("other.csv", "signals")


def test_a_body_that_does_not_fit_leaves_the_shirt_before(signed_in: Any) -> None:
    before = signed_in.good("GET", "/equipment")
    signed_in.process.refuse["body"] = "This body has no joint of that shirt: choose another body."
    chosen = {"kind": "simulator", "seed": 7}
    assert "choose another body" in signed_in.refused(409, "PUT", "/equipment/shirt", json=chosen)
    del signed_in.process.refuse["body"]
    after = signed_in.good("GET", "/equipment")
    assert (after["shirt"], after["body"]) == (before["shirt"], before["body"])
    assert after["layout"]["name"] == LAYOUT.name


def test_a_refused_file_is_named_without_its_place(signed_in: Any, settings: Any) -> None:
    file = settings.files / "walk.csv"
    file.parent.mkdir(parents=True)
    file.write_bytes(b"t,a\n0,x\n")
    signed_in.process.refuse["shirt"] = f"{file}, line 2, column 'a': 'x' is not a number, write one."
    said = signed_in.refused(409, "PUT", "/equipment/shirt", json={"kind": "replay", "file": "walk.csv"})
    assert said.lower().startswith("walk.csv, line 2")


def test_junk_leaves_the_live_socket_open(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        for message in ("[" * 4000, '{"a":' * 800, "junk", "null", '{"move":{"x":NaN}}'):
            socket.send_text(message)
            for _ in range(3):
                assert socket.receive_json()["state"] == "disarmed", message[:20]


def test_what_is_no_text_closes_the_live_socket(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        socket.send_bytes(b"\xff\x00")
        assert closing(socket) == 1003


def test_a_session_does_not_change_under_a_trial_that_begins(calibrated: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    other = calibrated.add_patient("P-2")
    asked: list[Any] = []
    start = TrialFlow.start
    with ThreadPoolExecutor(1) as screen:

        async def slowly(self: TrialFlow, *given: Any) -> int:
            asked.append(screen.submit(calibrated, "POST", "/session", json={"patient_id": other}))
            await asyncio.sleep(0.3)
            return await start(self, *given)

        monkeypatch.setattr(TrialFlow, "start", slowly)
        calibrated.start_trial()
        assert "A trial is running" in sentence_of(asked[0].result(), 409)
    assert calibrated.good("GET", "/session")["patient"]["id"] == calibrated.patient["id"]
    calibrated.end_trial()


def test_a_step_whose_end_cannot_be_written_is_over(signed_in: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/rest/start")

    def full(*_given: Any) -> None:
        raise OSError("disk full")

    with monkeypatch.context() as broken:
        broken.setattr(CalibrationFlow, "_set", full)
        signed_in.end_step()
    assert signed_in.good("POST", "/calibration/steps/rest/start")["running"]["step"] == "rest"
    signed_in.good("POST", "/calibration/steps/rest/cancel")
