"""An upload under a taken name never replaces a file silently, and a replaced file can be restored."""

import io
import json
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from typing import Any

import pytest
import trimesh
from api.plan_documents import plan

from app.clock import utc_now
from app.store.files.replacements import replaced_files


def recording(clinic: Any, number: int, name: str, same_name: str) -> Any:
    content = f"t,a\n0,{number}\n".encode()
    return clinic("POST", f"/equipment/files{same_name}", files={"file": (name, io.BytesIO(content), "text/csv")})


def model(clinic: Any, number: int, name: str, same_name: str) -> Any:
    content = trimesh.creation.box((1.0, 1.0 + number, 1.0)).export(file_type="glb")
    return clinic("POST", f"/models{same_name}", files={"file": (name, content)})


def floor_plan(clinic: Any, number: int, name: str, same_name: str) -> Any:
    return clinic("POST", f"/floorplans{same_name}", json=plan(name, title=f"Room {number}"))


# What brings something, under which name, which names are proposed, and the folder in which it lies.
KINDS = [
    pytest.param(recording, "walk.csv", ["walk-2.csv", "walk-3.csv"], "files", id="recording"),
    pytest.param(model, "bed.glb", ["bed-2.glb", "bed-3.glb"], "models", id="model"),
    pytest.param(floor_plan, "room", ["room-2", "room-3"], "floorplans", id="floor plan"),
]


def contents(settings: Any, folder: str) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in (settings.state / folder).glob("*") if file.is_file()}


@pytest.mark.parametrize(("bring", "name", "proposed", "folder"), KINDS)
def test_nothing_is_replaced_unless_a_person_says_so(
    signed_in: Any, settings: Any, bring: Any, name: str, proposed: list[str], folder: str
) -> None:
    assert bring(signed_in, 1, name, "").status_code == 201
    first = contents(settings, folder)
    for spelled in (name, name.replace(name[0], name[0].upper(), 1)):
        answer = bring(signed_in, 2, spelled, "")
        assert answer.status_code == 409
        assert answer.json()["detail"].startswith(f"There is '{name}' already: keep both, or replace it")
        assert answer.json()["choice"]["may_replace"] is True
    assert answer.json()["choice"]["proposed"].lower() == proposed[0]
    assert contents(settings, folder) == first
    assert signed_in.good("GET", "/replaced") == []
    assert bring(signed_in, 2, name, "?same_name=keep-both").status_code == 201
    both = contents(settings, folder)
    assert len(both) == 2
    assert first.items() < both.items()
    assert bring(signed_in, 3, name, "?same_name=surprise").status_code == 422


@pytest.mark.parametrize(("bring", "name", "proposed", "folder"), KINDS)
def test_what_was_replaced_can_be_put_back(
    signed_in: Any, settings: Any, bring: Any, name: str, proposed: list[str], folder: str
) -> None:
    bring(signed_in, 1, name, "")
    (first,) = contents(settings, folder).values()
    assert bring(signed_in, 2, name, "?same_name=replace").status_code == 201
    (second,) = contents(settings, folder).values()
    assert second != first
    (row,) = signed_in.good("GET", "/replaced")
    assert (row["name"].startswith(name), row["bytes"]) == (True, len(first))
    back = signed_in.good("POST", f"/replaced/{row['kind']}/{row['id']}/restore")
    assert back["name"] == proposed[0]
    stored = contents(settings, folder)
    assert (second in stored.values(), len(stored)) == (True, 2)
    if folder == "floorplans":
        assert signed_in.good("GET", f"/floorplans/{proposed[0]}")["title"] == "Room 1"
    else:
        assert first in stored.values()
    assert signed_in.good("GET", "/replaced") == []
    assert signed_in("POST", f"/replaced/{row['kind']}/{row['id']}/restore").status_code == 404
    assert signed_in.log()[-1].what == "replaced file restored"


def test_what_was_replaced_stays_for_30_days(signed_in: Any, settings: Any) -> None:
    recording(signed_in, 1, "walk.csv", "")
    recording(signed_in, 2, "walk.csv", "?same_name=replace")
    now = utc_now()
    for days, left in ((29, 1), (31, 0)):
        replaced_files(settings).purge(now + timedelta(days=days))
        assert len(signed_in.good("GET", "/replaced")) == left


def test_of_many_who_bring_one_name_at_the_same_moment_one_is_stored(signed_in: Any, settings: Any) -> None:
    with ThreadPoolExecutor(6) as people:
        answers = list(people.map(lambda number: recording(signed_in, number, "walk.csv", "").status_code, range(6)))
    assert sorted(answers) == [201, 409, 409, 409, 409, 409]
    assert len(contents(settings, "files")) == 1


def test_a_recording_of_this_program_is_not_replaced(signed_in: Any, settings: Any) -> None:
    (settings.files / "walk.csv").mkdir(parents=True)
    for same_name in ("", "?same_name=replace"):
        answer = recording(signed_in, 1, "walk.csv", same_name)
        choice = {"proposed": "walk-2.csv", "may_replace": False}
        assert (answer.status_code, answer.json()["choice"]) == (409, choice)
    assert recording(signed_in, 1, "walk.csv", "?same_name=keep-both").status_code == 201


def test_nothing_but_the_shelf_is_put_back(signed_in: Any) -> None:
    for identity in ("..--x", "x", "20260101T000000.0Z--..%2f..%2fbodydrive.sqlite"):
        answer = signed_in("POST", f"/replaced/file/{identity}/restore")
        assert answer.status_code in {404, 405, 422}, identity
        assert isinstance(json.loads(answer.text)["detail"], str), identity
