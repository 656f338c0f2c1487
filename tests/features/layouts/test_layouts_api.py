"""Layouts of a clinic at the API: saved, changed, deleted, used; calibrations keep theirs."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from api.fake_clinic import Clinic, is_news, next_message, sentence_of
from api.fake_process import LAYOUT
from features.layouts.test_joint_groups import RATE, channels
from hardware.shirt.shirts import small_layout

from app.features.layouts import service
from app.hardware.shirt.camera import CAMERA_LAYOUT
from app.hardware.shirt.standard import bundled_layout, standard_layout
from app.layout import ShirtLayout
from app.session.control_link import ControlLink
from app.settings import Settings

SMALL = small_layout().model_dump(mode="json")


def named(name: str, layout: ShirtLayout | None = None) -> dict[str, Any]:
    return (layout or small_layout()).model_dump(mode="json") | {"name": name}


def saved(clinic: Clinic, layout: dict[str, Any]) -> dict[str, Any]:
    """Save a layout, and return its entry of the list."""
    (entry,) = [one for one in clinic.good("POST", "/layouts", json=layout)["own"] if one["layout"] == layout]
    return dict(entry)


def uses(clinic: Clinic) -> dict[str, str]:
    """Return how the shirt in use has each layout, by its name."""
    view = clinic.good("GET", "/layouts")
    return {one["layout"]["name"]: one["use"] for one in (*view["own"], *view["bundled"])}


def test_a_layout_is_saved_changed_and_deleted_and_the_log_says_so(signed_in: Clinic) -> None:
    entry = saved(signed_in, SMALL)
    assert (entry["version"], entry["use"]) == (1, "none")
    path = f"/layouts/{entry['id']}"
    changed = named("Vest")
    (now,) = signed_in.good("PUT", path, json={"version": 1, "layout": changed})["own"]
    assert (now["layout"], now["version"], now["id"]) == (changed, 2, entry["id"])
    stale = {"version": 1, "layout": SMALL}
    assert "saved on another screen meanwhile" in signed_in.refused(409, "PUT", path, json=stale)
    assert signed_in.good("DELETE", path)["own"] == []
    assert "There is no layout" in signed_in.refused(404, "DELETE", path)
    rows = [(row.what, row.details.get("name"), row.details.get("version")) for row in signed_in.log()]
    assert rows[-3:] == [("layout saved", "small", 1), ("layout saved", "Vest", 2), ("layout deleted", "Vest", None)]


def test_the_pages_are_told_of_a_layout_alone_and_it_has_one_moment(signed_in: Clinic) -> None:
    with signed_in.socket("/live") as socket:
        entry = saved(signed_in, SMALL)
        next_message(socket, is_news("layouts"))
    assert signed_in.good("GET", "/layouts")["own"] == [entry]


def test_a_name_is_taken_once_whatever_its_case_also_by_those_of_the_program(signed_in: Clinic) -> None:
    entry = saved(signed_in, SMALL)
    other = saved(signed_in, named("Vest"))
    for taken in ("small", "SMALL", "vest", standard_layout().name):
        sentence = signed_in.refused(409, "POST", "/layouts", json=named(taken))
        assert f"There is a layout “{taken}” already" in sentence
    body = {"version": 1, "layout": named("Small")}
    assert "already" in signed_in.refused(409, "PUT", f"/layouts/{other['id']}", json=body)
    signed_in.good("PUT", f"/layouts/{entry['id']}", json=body)  # its own name in another case
    assert [one["layout"]["name"] for one in signed_in.good("GET", "/layouts")["own"]] == ["Small", "Vest"]


def test_those_of_the_program_are_listed_and_have_no_address(signed_in: Clinic) -> None:
    view = signed_in.good("GET", "/layouts")
    layouts = {one["layout"]["name"]: ShirtLayout.model_validate(one["layout"]) for one in view["bundled"]}
    shipped = [standard_layout(), bundled_layout(CAMERA_LAYOUT)]
    assert layouts == {layout.name: layout for layout in shipped}
    assert view["own"] == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"channels": []}, "channels"),
        ({"joints": [*SMALL["joints"], *SMALL["joints"]]}, "stands there twice"),
        ({"channels": [{**SMALL["channels"][0], "joint": "knee"}]}, "names joint 'knee'"),
        ({"channels": [{**SMALL["channels"][0], "position": [0.5, 2]}]}, "at most 1"),
        ({"name": "a\u202eb"}, "U+202E"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_what_is_no_layout_is_one_sentence_and_nothing_is_saved(
    signed_in: Clinic, change: dict[str, Any], words: str
) -> None:
    assert words in signed_in.refused(422, "POST", "/layouts", json=SMALL | change)
    assert signed_in.good("GET", "/layouts")["own"] == []


def test_nobody_but_a_driver_says_which_channels_are_live(signed_in: Clinic) -> None:
    """A shirt in use has such a layout as it is saved, so that it is found again."""
    claimed = SMALL | {"channels": [channel | {"liveness": "arrival"} for channel in SMALL["channels"]]}
    (entry,) = signed_in.good("POST", "/layouts", json=claimed)["own"]
    assert entry["layout"] == SMALL


def test_there_is_an_end_of_them(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(service, "MOST_LAYOUTS", 1)
    saved(signed_in, SMALL)
    assert "at most 1 layouts" in signed_in.refused(409, "POST", "/layouts", json=named("Vest"))


def test_the_layout_of_the_shirt_in_use_cannot_be_deleted(signed_in: Clinic) -> None:
    entry = saved(signed_in, SMALL)
    signed_in.process.layout = small_layout()
    signed_in.good("PUT", "/equipment/shirt", json={"kind": "udp", "port": 0, "layout": SMALL})
    assert uses(signed_in)["small"] == "same"
    assert "use another layout first" in signed_in.refused(409, "DELETE", f"/layouts/{entry['id']}")
    changed = {**SMALL, "joints": [{"name": "right_elbow", "label": "Elbow"}]}
    signed_in.good("PUT", f"/layouts/{entry['id']}", json={"version": 1, "layout": changed})
    assert uses(signed_in)["small"] == "changed"  # the shirt has what it was given
    assert signed_in.good("GET", "/equipment")["layout"] == SMALL
    assert "use another layout first" in signed_in.refused(409, "DELETE", f"/layouts/{entry['id']}")
    signed_in.process.layout = LAYOUT
    signed_in.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 1})
    signed_in.good("DELETE", f"/layouts/{entry['id']}")


def test_a_layout_made_of_a_shirt_that_has_its_own_is_not_in_use_and_can_be_deleted(signed_in: Clinic) -> None:
    own = bundled_layout(CAMERA_LAYOUT).model_copy(update={"name": "phones"})
    channels = tuple(channel.model_copy(update={"liveness": "arrival"}) for channel in own.channels)
    signed_in.process.layout = own.model_copy(update={"channels": channels})
    signed_in.good("PUT", "/equipment/shirt", json={"kind": "phones"})
    body = signed_in.good("GET", "/equipment")["layout"]
    assert body["channels"][0]["liveness"] == "arrival"
    (entry,) = signed_in.good("POST", "/layouts", json=body)["own"]
    assert entry["use"] == "none"
    assert signed_in.good("DELETE", f"/layouts/{entry['id']}")["own"] == []


def test_a_calibration_keeps_its_layout_whatever_is_saved_or_used(calibrated: Clinic) -> None:
    before = calibrated.process.parameters
    assert before is not None
    digest = calibrated.good("GET", "/drives/summary")["parameters"]["hash"]
    entry = saved(calibrated, LAYOUT.model_dump(mode="json"))

    # Other joints of channels of equal names: the map that was calibrated drives on, as it was.
    whole = [{**channel, "joint": "right_elbow"} for channel in entry["layout"]["channels"]]
    joints = [{"name": "right_elbow", "label": "Right elbow"}]
    other = {"name": LAYOUT.name, "channels": whole, "joints": joints}
    calibrated.good("PUT", f"/layouts/{entry['id']}", json={"version": 1, "layout": other})
    assert calibrated.process.parameters == before
    calibrated.process.layout = ShirtLayout.model_validate(other)
    calibrated.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 1, "layout": other})
    assert calibrated.process.parameters == before
    assert calibrated.good("GET", "/drives/summary")["parameters"]["hash"] == digest

    # Channels of other names, or in another order: another shirt, in which nobody was calibrated.
    swapped = {**other, "channels": [whole[1], whole[0], *whole[2:]]}
    calibrated.process.layout = ShirtLayout.model_validate(swapped)
    calibrated.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 1, "layout": swapped})
    assert calibrated.process.parameters is None
    assert "calibrated in another shirt" in calibrated.good("GET", "/controls")["obstacle"]["message"]

    calibrated.process.layout = LAYOUT
    calibrated.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 1})
    assert calibrated.process.parameters == before


def test_joints_are_proposed_of_what_the_shirt_sends(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    too_short = signed_in.good("GET", "/layouts/proposal")
    assert (too_short["groups"], too_short["still"]) == ([], [])
    assert too_short["message"].startswith("Fewer than 10 seconds")
    asked: list[Any] = []

    def frames(_link: ControlLink, *given: Any) -> Any:
        asked.append(given)
        return channels([0, 0, 1, 1, 2, 2, 3, 3], np.random.default_rng(1), seconds=40.0)

    monkeypatch.setattr(ControlLink, "newest_frames", frames)
    found = signed_in.good("GET", "/layouts/proposal?seconds=20")
    assert asked == [(8, 100.0, 20)]
    assert (found["groups"], found["still"]) == ([[0, 1], [2, 3], [4, 5], [6, 7]], [])
    assert found["message"] == "4 groups of sensors move together."
    assert signed_in("GET", "/layouts/proposal?seconds=1").status_code == 422


def test_a_file_of_signals_has_a_draft(signed_in: Clinic, settings: Settings) -> None:
    values = channels([0, 0, 1, 1], np.random.default_rng(2))
    rows = [",".join([f"{i / RATE:.3f}", *(f"{value:.6f}" for value in row)]) for i, row in enumerate(values)]
    file = Path(settings.files / "walk.csv")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join(["t,a,b,c,d", *rows]) + "\n")
    draft = signed_in.good("POST", "/layouts/draft", json={"file": "walk.csv"})
    assert [channel["name"] for channel in draft["layout"]["channels"]] == ["a", "b", "c", "d"]
    assert draft["proposal"]["groups"] == [[0, 1], [2, 3]]
    file.write_text("\n".join(["t,hand.x,hand.y,head.x,head.y", *rows]) + "\n")
    named_by_columns = signed_in.good("POST", "/layouts/draft", json={"file": "walk.csv"})
    assert [joint["name"] for joint in named_by_columns["layout"]["joints"]] == ["hand", "head"]
    assert named_by_columns["proposal"] is None
    file.write_text("t,a\n0,x\n")
    assert signed_in.refused(409, "POST", "/layouts/draft", json={"file": "walk.csv"}).startswith("Walk.csv")
    assert "Add a file" in signed_in.refused(404, "POST", "/layouts/draft", json={"file": "../clinic.sqlite"})


def test_a_reviewer_sees_no_layouts(signed_in: Clinic) -> None:
    with signed_in.as_person(signed_in.cookies_of("Rita", "reviewer", None)):
        assert sentence_of(signed_in("GET", "/layouts"), 403)
        assert sentence_of(signed_in("POST", "/layouts", json=SMALL), 403)
