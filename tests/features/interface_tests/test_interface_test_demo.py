"""A whole two-minute test of the demonstration's simulated person, in real processes; its figures computed again."""

import time

import pytest
from processes.served_demo import SessionClient, running_demo

from app.features.interface_tests.service import measure_interface_test
from app.recording.reader import read_run
from app.world.cursor_task import CursorPlan

pytestmark = [pytest.mark.long]

LIMIT = 200.0  # s for the test, its recording and its measures


def test_the_simulated_person_does_a_test_and_the_recording_gives_its_figures(tmp_path):
    with running_demo(TMPDIR=str(tmp_path)) as link:
        address, _, code = link.partition("/#demo=")
        with SessionClient(address) as client:
            client.request("POST", "/auth/demo", json={"code": code}).raise_for_status()
            patient = client.request("GET", "/session").json()["patient"]["id"]
            client.request("POST", "/interface-tests", json={"screen": "the-screen-of-the-tests"}).raise_for_status()
            deadline = time.monotonic() + LIMIT
            while True:
                (test,) = client.request("GET", f"/interface-tests?patient={patient}").json()["tests"]
                if test["status"] == "done":
                    break
                assert time.monotonic() < deadline
                time.sleep(1.0)
        assert test["end"] == "complete"
        measures = test["measures"]
        assert measures["complete"]
        assert measures["acquired"] > 25  # a practised person
        assert measures["throughput"] > 0.8
        folders = [file.parent for file in tmp_path.rglob("run.json")]
        (folder,) = [one for one in folders if read_run(one, ["t"]).meta["kind"] == "interface_test"]
        plan = CursorPlan.model_validate(read_run(folder, ["t"]).meta["interface_test"])
        assert measure_interface_test(folder, plan) == measures
