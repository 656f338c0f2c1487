"""The size of a 3D object is asked about where it is improbable in metres, and the object is stored in metres."""

from pathlib import Path
from typing import Any

import pytest
import trimesh
from api.fake_clinic import sentence_of

from app.scene.models.glb_import import read_model
from app.scene.models.objects import READINGS


def bed(*size: float) -> bytes:
    """Return a box whose length, width and height are given: ahead, left and up."""
    length, width, height = size
    content: bytes = trimesh.creation.box((width, height, length)).export(file_type="glb")
    return content


def bring(clinic: Any, content: bytes, query: str = "") -> Any:
    return clinic("POST", f"/models{query}", files={"file": ("bed.glb", content)})


@pytest.mark.parametrize(
    ("size", "said", "scales"),
    [
        ((3000, 1000, 2000), "3,000 x 1,000 x 2,000 m", {0.001: [3, 1, 2]}),
        (
            (200, 90, 55),
            "200 x 90 x 55 m",
            {0.001: [0.2, 0.09, 0.055], 0.01: [2, 0.9, 0.55], 0.0254: [5.08, 2.286, 1.397]},
        ),
        ((0.03, 0.01, 0.02), "0.03 x 0.01 x 0.02 m", {100.0: [3, 1, 2]}),
        ((0.002, 0.001, 0.002), "0.002 x 0.001 x 0.002 m", {100.0: [0.2, 0.1, 0.2], 1000.0: [2, 1, 2]}),
        ((100_000, 1, 1), "100,000 x 1 x 1 m", {}),
    ],
)
def test_an_improbable_size_is_asked_about(
    signed_in: Any, settings: Any, size: tuple[float, ...], said: str, scales: dict[float, list[float]]
) -> None:
    answer = bring(signed_in, bed(*size))
    words = sentence_of(answer, 422)
    assert words.startswith("bed.glb")
    assert said in words
    found = {each["metres_per_unit"]: each["size"] for each in answer.json()["choice"]["scales"]}
    assert found == {scale: pytest.approx(size) for scale, size in scales.items()} | {1.0: pytest.approx(list(size))}
    assert signed_in.good("GET", "/models") == []
    assert not settings.models.exists() or not [file for file in settings.models.rglob("*") if file.is_file()]


def test_a_probable_size_is_not_asked_about(signed_in: Any, settings: Any) -> None:
    for size in ((0.1, 0.05, 0.05), (3, 1, 2), (10, 0.2, 2.5)):
        listed = bring(signed_in, bed(*size), "?same_name=replace").json()
        assert [one["size"] for one in listed] == [pytest.approx(list(size))]
        assert (settings.models / "bed.glb").read_bytes() == bed(*size)


@pytest.mark.parametrize(("size", "scale"), [((3000, 1000, 2000), 0.001), ((0.03, 0.01, 0.02), 100)])
def test_an_object_is_stored_in_metres(signed_in: Any, settings: Any, size: tuple[float, ...], scale: float) -> None:
    (listed,) = bring(signed_in, bed(*size), f"?metres_per_unit={scale}").json()
    assert listed["size"] == pytest.approx([3, 1, 2])
    stored = settings.models / "bed.glb"
    assert read_model(stored).size == pytest.approx((3, 1, 2))
    assert len(list((settings.models / READINGS).iterdir())) == 1
    bring(signed_in, bed(1, 1, 1), "?same_name=replace")
    (row,) = signed_in.good("GET", "/replaced")
    name = signed_in.good("POST", f"/replaced/model/{row['id']}/restore")["name"]
    back = {each["name"]: each["size"] for each in signed_in.good("GET", "/models")}
    assert back[Path(name).stem] == pytest.approx([3, 1, 2])


def test_an_improbable_size_can_be_right(signed_in: Any, settings: Any) -> None:
    (listed,) = bring(signed_in, bed(0.03, 0.01, 0.02), "?metres_per_unit=1").json()
    assert listed["size"] == pytest.approx([0.03, 0.01, 0.02])
    assert (settings.models / "bed.glb").read_bytes() == bed(0.03, 0.01, 0.02)
    assert bring(signed_in, bed(0.03, 0.01, 0.02), "?same_name=keep-both").status_code == 422  # asked again
    assert [each["name"] for each in signed_in.good("GET", "/models")] == ["bed"]


def test_a_taken_name_and_an_improbable_size_are_two_questions(signed_in: Any) -> None:
    bring(signed_in, bed(1, 1, 1))
    large = bed(3000, 1000, 2000)
    assert "already" in sentence_of(bring(signed_in, large), 409)
    assert "improbable" in sentence_of(bring(signed_in, large, "?same_name=keep-both"), 422)
    answer = bring(signed_in, large, "?same_name=keep-both&metres_per_unit=0.001")
    assert {each["name"]: each["size"] for each in answer.json()} == {"bed": [1, 1, 1], "bed-2": [3, 1, 2]}


def test_a_scale_is_a_bounded_number(signed_in: Any) -> None:
    for scale in ("0", "-1", "nan", "inf", "1e999", "1001", "mm", ""):
        sentence_of(bring(signed_in, bed(3000, 1000, 2000), f"?metres_per_unit={scale}"), 422, f"{scale}: ")
    assert signed_in.good("GET", "/models") == []
