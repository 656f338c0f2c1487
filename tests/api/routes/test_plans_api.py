"""The clinic's own floor plans: saved, versioned, deleted, restored, checked, and made from files."""

import io
import json
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import ezdxf.filemanagement
import numpy as np
import pytest
import trimesh
from api.fake_clinic import WORD, sentence_of
from api.plan_documents import PATH, ROOM, plan
from PIL import Image

from app import isolated_reader
from app.api import foreign_files
from app.world.floorplan import load_floorplan


def names(clinic: Any) -> list[str]:
    return [one["name"] for one in clinic.good("GET", "/floorplans")]


def test_a_plan_is_saved_and_can_be_driven_in_at_once(signed_in: Any) -> None:
    saved = signed_in.good("POST", "/floorplans", json=plan())
    assert saved == {"name": "my-room", "title": "My room", "version": 1}
    assert "my-room" in names(signed_in)
    assert signed_in.good("GET", "/floorplans/my-room")["walls"] == ROOM
    assert signed_in.good("GET", "/own-floorplans") == [saved]
    row = signed_in.log()[-1]
    assert (row.what, row.details) == ("floor plan saved", {"floorplan": "my-room", "version": 1})


def test_every_version_stays(signed_in: Any, settings: Any) -> None:
    folder = settings.state / "floorplans"
    signed_in.good("POST", "/floorplans", json=plan())
    first = (folder / "my-room.json").read_bytes()
    second = signed_in.good("PUT", "/floorplans/my-room?version=1", json=plan(title="Larger"))
    assert second["version"] == 2
    kept = sorted((folder / "versions" / "my-room").iterdir())
    assert [file.name for file in kept] == ["000001.json", "000002.json"]
    assert kept[0].read_bytes() == first
    assert load_floorplan(folder / "my-room.json").title == "Larger"


def test_who_saves_an_old_version_is_told(signed_in: Any) -> None:
    signed_in.good("POST", "/floorplans", json=plan())
    signed_in.good("PUT", "/floorplans/my-room?version=1", json=plan(title="Theirs"))
    words = signed_in.refused(409, "PUT", "/floorplans/my-room?version=1", json=plan(title="Mine"))
    assert "meanwhile" in words
    assert signed_in.good("GET", "/floorplans/my-room")["title"] == "Theirs"
    signed_in.refused(422, "PUT", "/floorplans/my-room", json=plan())
    assert "name" in signed_in.refused(422, "PUT", "/floorplans/other?version=1", json=plan())
    signed_in.refused(404, "PUT", "/floorplans/other?version=1", json=plan("other"))


def test_of_two_who_save_at_the_same_moment_one_is_told(signed_in: Any) -> None:
    signed_in.good("POST", "/floorplans", json=plan())

    def save(number: int) -> int:
        status: int = signed_in("PUT", "/floorplans/my-room?version=1", json=plan(title=f"Of {number}")).status_code
        return status

    with ThreadPoolExecutor(4) as pool:
        assert sorted(pool.map(save, range(4))) == [200, 409, 409, 409]
    assert signed_in.good("GET", "/own-floorplans")[0]["version"] == 2


def test_a_file_that_somebody_put_there_is_a_version_too(signed_in: Any, settings: Any) -> None:
    folder = settings.state / "floorplans"
    folder.mkdir(parents=True)
    (folder / "by-hand.json").write_text(json.dumps(plan("by-hand")))
    assert signed_in.good("GET", "/own-floorplans")[0]["version"] == 1
    assert signed_in.good("PUT", "/floorplans/by-hand?version=1", json=plan("by-hand", title="New"))["version"] == 2
    assert load_floorplan(folder / "versions" / "by-hand" / "000001.json").title == "My room"


def test_a_plan_of_an_earlier_version_that_has_too_many_pieces_says_so(in_session: Any, settings: Any) -> None:
    in_session.good("POST", "/floorplans", json=plan("map"))
    zigzag = [[x / 1000, 10 + x % 2] for x in range(2502)]
    stored = json.dumps(plan("map", walls=[*ROOM, zigzag, zigzag]))
    for file in (settings.floorplans / "map.json", settings.floorplans / "versions" / "map" / "000002.json"):
        file.write_text(stored)
    words = "The floor plan 'map' cannot be used: its walls have 5,006 pieces, and at most 5,000 are taken"
    assert words in in_session.refused(409, "GET", "/floorplans/map")
    where = {"floorplan": "map", "path": "main", "screen": WORD}
    assert words in in_session.refused(409, "POST", "/trials", json=where)
    assert "map" not in names(in_session)
    listed = [{"name": "map", "title": "map", "version": 2}]
    assert in_session.good("GET", "/own-floorplans") == listed
    assert in_session.good("DELETE", "/floorplans/map") == []
    assert in_session.good("POST", "/floorplans/map/restore") == listed
    assert in_session.good("PUT", "/floorplans/map?version=2", json=plan("map"))["version"] == 3
    assert "map" in names(in_session)


def test_what_comes_with_the_software_stays_as_it_is(signed_in: Any) -> None:
    for name in ("clinic", "Clinic", "desert.easy", "desert", "desert.impossible"):
        assert "comes with the software" in signed_in.refused(409, "POST", "/floorplans", json=plan(name)), name
        signed_in.refused(409, "PUT", f"/floorplans/{name}?version=1", json=plan(name))
        signed_in.refused(409, "DELETE", f"/floorplans/{name}")


def test_a_deleted_plan_can_be_restored(signed_in: Any) -> None:
    signed_in.good("POST", "/floorplans", json=plan())
    signed_in.good("PUT", "/floorplans/my-room?version=1", json=plan(title="Larger"))
    assert signed_in.good("DELETE", "/floorplans/my-room") == []
    assert "my-room" not in names(signed_in)
    signed_in.refused(404, "DELETE", "/floorplans/my-room")
    (back,) = signed_in.good("POST", "/floorplans/my-room/restore")
    assert back == {"name": "my-room", "title": "Larger", "version": 2}
    signed_in.refused(404, "POST", "/floorplans/my-room/restore")
    assert [row.what for row in signed_in.log()[-2:]] == ["floor plan deleted", "floor plan restored"]
    signed_in.good("DELETE", "/floorplans/my-room")
    assert signed_in.good("POST", "/floorplans", json=plan(title="Third"))["version"] == 3


def test_a_bad_plan_is_refused_with_the_place(signed_in: Any) -> None:
    changes: list[tuple[dict[str, Any], str]] = [
        ({"name": "../x"}, "name"),
        ({"walls": [[[0, 0]]]}, "walls[0]"),
        ({"walls": [[[0, 0], ["1", 0]]]}, "walls[0][1][0]"),
        ({"paths": []}, "paths"),
        ({"surprise": 1}, "surprise"),
        ({"paths": [PATH, PATH]}, "twice"),
        ({"paths": [{**PATH, "points": [[1, 2], [5.9, 2]]}]}, "a wall near (5.90, 2.00)"),
    ]
    for change, words in changes:
        assert words in signed_in.refused(422, "POST", "/floorplans", json={**plan(), **change}), change
        answer = signed_in.good("POST", "/floorplans/check", json={**plan(), **change})
        assert (answer["good"], words in answer["sentence"]) == (False, True), change
    assert signed_in.good("GET", "/own-floorplans") == []


def test_the_check_says_where_on_the_floor(signed_in: Any) -> None:
    def checked(**changed: Any) -> Any:
        return signed_in.good("POST", "/floorplans/check", json=plan(**changed))

    assert checked() == {"good": True, "sentence": "", "place": [], "at": None}
    assert checked(paths=[{**PATH, "points": [[1, 2], [5, 3.8]]}])["at"] == [5.0, 3.8]
    assert checked(walls=[[[0, 0], [0, 2000]]])["place"][:2] == ["walls", 0]
    for content in (b"", b"[" * 100_000, b"\xff\xfe", b"[]", b'{"name": NaN}'):
        assert not signed_in.good("POST", "/floorplans/check", content=content)["good"]
        signed_in.refused(422, "POST", "/floorplans", content=content)


def test_more_than_a_plan_can_hold_is_not_taken(signed_in: Any) -> None:
    assert "8 MB" in signed_in.refused(413, "POST", "/floorplans", content=b" " * 8_200_000)
    many = [[x / 10, 1.0] for x in range(5000)]
    walls = [[[0.0, 3.0 + y / 10], [1.0, 3.0 + y / 10]] for y in range(4000)]
    answer = signed_in.good("POST", "/floorplans/check", json=plan(walls=walls, paths=[{**PATH, "points": many}]))
    assert "too many points" in answer["sentence"]
    crowd = b'{"walls": [' + b"[]," * 260_000 + b"[]]}"
    assert "more than 250,000 points" in signed_in.good("POST", "/floorplans/check", content=crowd)["sentence"]
    assert "more than 250,000 points" in signed_in.refused(422, "POST", "/floorplans", content=crowd)


def dxf(unit: int = 6) -> bytes:
    document = ezdxf.filemanagement.new()
    document.header["$INSUNITS"] = unit
    document.modelspace().add_lwpolyline([(0, 0), (8, 0), (8, 6), (0, 6)], close=True, dxfattribs={"layer": "A-WALL"})
    text = io.StringIO()
    document.write(text)
    return text.getvalue().encode()


def picture(kind: str) -> bytes:
    pixels = np.full((90, 160), 254, np.uint8)
    pixels[5:85, 5:155] = 0
    pixels[10:80, 10:150] = 254
    stream = io.BytesIO()
    Image.fromarray(pixels).save(stream, kind)
    return stream.getvalue()


MAP = b"image: /etc/passwd\nresolution: 0.05\norigin: [0, 0, 0]\n"


def bring(clinic: Any, *files: tuple[str, bytes], **options: Any) -> Any:
    sent = [("files", (name, content)) for name, content in files]
    return clinic("POST", "/floorplans/import", files=sent, data={"options": json.dumps(options)})


def test_files_become_drafts_that_can_be_saved(signed_in: Any) -> None:
    for files, options, width in (
        ([("Hall 1.dxf", dxf())], {}, 8.0),
        ([("hall.PNG", picture("PNG"))], {"width": 8.0}, 7.0),
        ([("hall.yaml", MAP), ("hall.pgm", picture("PPM"))], {"title": "The hall"}, 7.0),
    ):
        answer = bring(signed_in, *files, **options)
        assert answer.status_code == 200, answer.text
        draft = answer.json()
        xs = [x for wall in draft["document"]["walls"] for x, _ in wall]
        assert max(xs) - min(xs) == pytest.approx(width, abs=0.11)
        assert draft["messages"][0] == "4 wall pieces."
        assert signed_in.good("POST", "/floorplans/check", json=draft["document"])["good"]
    assert signed_in.good("GET", "/own-floorplans") == []
    drawn = bring(signed_in, ("h.dxf", dxf())).json()
    assert drawn["layers"] == drawn["taken"] == ["A-WALL"]


def test_bad_files_are_refused_in_one_sentence(signed_in: Any) -> None:
    for files, options, status, words in (
        ([("hall.dxf", dxf(0))], {}, 422, "hall.dxf: this drawing does not say in which unit"),
        ([("hall.yaml", MAP), ("hall.pgm", b"x")], {}, 422, "hall.pgm: this is not an image"),
        ([("hall.yaml", MAP)], {}, 422, "two files"),
        ([("hall.pgm", picture("PPM"))], {}, 422, ".yaml"),
        ([("a.dxf", dxf()), ("b.dxf", dxf())], {}, 422, "one file"),
        ([("a.exe", b"MZ")], {}, 415, "none of these"),
        ([("hall.dxf", dxf())], {"unit": "yard"}, 422, "unit"),
        ([("hall.yaml", b"#" * 200_000), ("hall.pgm", b"x")], {}, 413, "100 kB"),
    ):
        assert words in sentence_of(bring(signed_in, *files, **options), status)
    answer = signed_in("POST", "/floorplans/import", files=[("files", ("a.dxf", b"x"))], data={"options": "{"})
    assert "not JSON" in sentence_of(answer, 422)
    signed_in.refused(422, "POST", "/floorplans/import")


def test_a_reader_that_dies_or_hangs_is_said(signed_in: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(foreign_files, "read_isolated", isolated_reader.read_isolated)
    monkeypatch.setattr(isolated_reader, "COMMAND", ("false",))
    assert "could not be read" in sentence_of(bring(signed_in, ("hall.dxf", dxf())), 422)
    monkeypatch.setattr(isolated_reader, "COMMAND", ("sh", "-c", "sleep 60", "-"))
    monkeypatch.setattr(isolated_reader, "LONGEST_WAIT", 0.05)
    assert "too long" in sentence_of(bring(signed_in, ("hall.dxf", dxf())), 503)


def glb() -> bytes:
    found: bytes = trimesh.creation.box((1.0, 2.0, 0.5)).export(file_type="glb")
    return found


def test_an_object_is_kept_and_given_to_a_box(signed_in: Any, settings: Any) -> None:
    listed = signed_in.good("POST", "/models", files={"file": ("My bed.glb", glb())})
    assert [one["name"] for one in listed] == ["My-bed"]
    assert sorted(listed[0]["size"]) == [0.5, 1.0, 2.0]
    assert listed[0]["bytes"] == len(glb())
    assert (settings.models / "My-bed.glb").read_bytes() == glb()
    assert signed_in.good("GET", "/models") == listed
    assert (signed_in.log()[-1].what, signed_in.log()[-1].details) == ("object added", {"model": "My-bed"})
    box = {"kind": "box", "label": "Bed", "position": [3, 3.4], "size": [0.5, 0.5], "model": "My-bed"}
    signed_in.good("POST", "/floorplans", json=plan(obstacles=[box]))
    assert signed_in.good("GET", "/floorplans/my-room")["obstacles"][0]["model"] == "My-bed"


def test_what_is_no_object_is_refused(signed_in: Any, settings: Any) -> None:
    for name, content, status, words in (
        ("bed.obj", b"v 0 0 0", 415, "no GLB"),
        ("bed.glb", b"glTF", 422, "bed.glb: this object cannot be used"),
        ("bed.glb", b"", 422, "bed.glb"),
        ("../../bed.glb", b"x", 422, "bed.glb"),
        ("bed.glb", b"\0" * 20_000_001, 413, "20 MB"),
    ):
        assert words in signed_in.refused(status, "POST", "/models", files={"file": (name, content)}), content[:9]
    assert not settings.models.exists() or list(settings.models.iterdir()) == []
