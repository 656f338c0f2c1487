"""Priors as documents: people are added, replaced and taken out; what leaves is a sum over eight or more."""

import json

import numpy as np
import pytest
from calibration.prior.simulated_wearers import Wearer, prior_of, sleeve
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from app.calibration.clean_recording import CleanRecording
from app.calibration.prior.documents import JointEntry, MomentsDocument, OwnPrior, PersonEntry
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import MapPrior, PriorError, union_of_people
from app.calibration.prior.prior_file import PRIOR, read_prior
from app.calibration.prior.release import release
from app.layout import ShirtLayout


@pytest.fixture(scope="module")
def ten():
    return prior_of(range(1, 11))


def part(prior, *numbers):
    return prior.model_copy(update={"people": {f"w{i}": prior.people[f"w{i}"] for i in numbers}})


def renamed_sleeve():
    other = sleeve().channels[0].model_copy(update={"name": "e9"})
    return sleeve().model_copy(update={"channels": (other, *sleeve().channels[1:])})


def assert_equal(one, other):
    assert one.joints.keys() == other.joints.keys()
    assert one.rings.keys() == other.rings.keys()
    for name, joint in one.joints.items():
        others = other.joints[name]
        assert (joint.people, joint.strokes) == (others.people, others.strokes)
        np.testing.assert_allclose(joint.expected, others.expected, rtol=1e-5)
        np.testing.assert_allclose(joint.moments.gram, others.moments.gram, rtol=1e-4, atol=1e-6)
        np.testing.assert_allclose(joint.moments.stroke_gram, others.moments.stroke_gram, rtol=1e-4, atol=1e-6)
    for name, ring in one.rings.items():
        np.testing.assert_allclose(ring.pairs, other.rings[name].pairs, rtol=1e-4, atol=1e-6)


def test_adding_a_person_and_taking_it_out_again_is_never_having_added(ten):
    before = part(ten, 1, 2, 3, 4)
    after = before.with_person("w9", ten.people["w9"]).without_person("w9")
    assert after == before
    assert after.model_dump_json() == before.model_dump_json()
    assert before.without_person("nobody") == before


def test_a_person_who_is_added_again_is_replaced(ten):
    again = ten.with_person("w1", person_entry([Wearer(77).recording()]))
    assert len(again.people) == 10
    assert again.people["w1"] != ten.people["w1"]


@given(split=st.integers(1, 9), seed=st.integers(0, 100))
@settings(max_examples=15, deadline=None)
def test_sums_of_parts_are_the_sum_of_the_whole(ten, split, seed):
    order = (np.random.default_rng(seed).permutation(10) + 1).tolist()
    one, other = part(ten, *order[:split]), part(ten, *order[split:])
    assert_equal(MapPrior.of(release([one, other]).document), MapPrior.of(ten))


def test_a_release_holds_no_person(ten):
    released = release([ten]).document
    assert released.people == 10
    assert "w1" not in released.model_dump_json()
    assert_equal(MapPrior.of(released), MapPrior.of(ten))
    assert release([released, released]).document.people == 20


def test_fewer_than_eight_are_not_released(ten):
    with pytest.raises(PriorError, match="7 people in all, and only sums over at least 8"):
        release([part(ten, 1, 2, 3), part(ten, 4, 5, 6, 7)])


def test_within_a_clinic_entries_are_united(ten):
    assert union_of_people([part(ten, 1, 2), part(ten, 2, 3)]) == part(ten, 1, 2, 3)
    with pytest.raises(PriorError, match="different entries for the person 'w1'"):
        union_of_people([part(ten, 1), part(ten, 2).model_copy(update={"people": {"w1": ten.people["w2"]}})])
    with pytest.raises(PriorError, match="holds sums"):
        union_of_people([release([ten]).document])


def test_other_layouts_are_not_added(ten):
    with pytest.raises(PriorError, match="needs a prior of its own"):
        release([ten, prior_of(range(1, 9), renamed_sleeve())])
    backwards = tuple(
        channel.model_copy(update={"place": 4 - place}) for place, channel in enumerate(sleeve().channels)
    )
    other_ring = ten.model_copy(update={"layout": sleeve().model_copy(update={"channels": backwards})})
    with pytest.raises(PriorError, match="needs a prior of its own"):
        release([ten, other_ring])


def test_rings_may_come_to_a_layout_later(ten):
    before = prior_of(range(11, 19), sleeve(ring=False))
    for both in (release([ten, before]).document, release([before, ten]).document):
        assert (both.people, both.layout, both.rings["cuff"].people) == (18, sleeve(), 10)
    assert union_of_people([before, ten]).layout == union_of_people([ten, before]).layout == sleeve()


def test_a_ring_of_other_sensors_is_left_out_of_an_entry(ten):
    entry = ten.people["w1"]
    assert entry.in_layout(sleeve()) == entry
    assert entry.in_layout(sleeve(ring=False)).rings == {}
    assert entry.in_layout(renamed_sleeve()).rings == {}
    assert entry.in_layout(renamed_sleeve()).joints == entry.joints


def test_a_file_is_read_as_it_was_written(ten, tmp_path):
    for document in (ten, release([ten]).document):
        (tmp_path / "prior.json").write_text(document.model_dump_json())
        assert read_prior(tmp_path / "prior.json") == document
    assert len((tmp_path / "prior.json").read_bytes()) < 40_000


@pytest.mark.parametrize("content", [None, "{}", "nothing", '{"kind": "own", "layout": {}}'])
def test_a_missing_or_bad_file_is_one_sentence(tmp_path, content):
    if content is not None:
        (tmp_path / "prior.json").write_text(content)
    with pytest.raises(ValueError, match="there is no such prior" if content is None else r"prior\.json"):
        read_prior(tmp_path / "prior.json")


def test_an_entry_for_other_channels_is_refused(ten):
    document = json.loads(part(ten, 1).model_dump_json())
    document["people"]["w1"]["joints"]["right_elbow"]["alive"].append(True)
    with pytest.raises(ValidationError, match="one number for each channel"):
        PRIOR.validate_python(document)
    document = json.loads(part(ten, 1).model_dump_json())
    document["people"]["w1"]["joints"]["right_elbow"]["moments"]["gram"].pop()
    with pytest.raises(ValidationError, match="do not fit together"):
        OwnPrior.model_validate_json(json.dumps(document))


def test_a_channel_that_one_person_lacks_counts_for_the_others(ten):
    wearer = Wearer(3)
    values = wearer.values.copy()
    values[:, 2] = 0.5
    lacking = CleanRecording.of(sleeve(), wearer.rate, values, stretches=[wearer.stretch(None, values)])
    entry = person_entry([lacking])
    assert entry.joints["right_elbow"].alive == (True, True, False, True, True)
    assert entry.rings == {}
    mixed = MapPrior.of(part(ten, 1, 2, 4, 5).with_person("w3", entry))
    assert mixed.joints["right_elbow"].alive.tolist() == [5, 5, 4, 5, 5]
    assert mixed.rings["cuff"].people == 4


def test_too_short_a_recording_is_refused():
    wearer = Wearer(1)
    short = CleanRecording.of(sleeve(), wearer.rate, wearer.values[:300], stretches=[wearer.stretch(1)])
    with pytest.raises(ValueError, match="record longer"):
        person_entry([short])
    with pytest.raises(ValueError, match="no joint was prompted"):
        person_entry([CleanRecording.of(sleeve(), wearer.rate, wearer.values)])


def test_a_layout_with_rings_is_checked():
    document = json.loads(sleeve().model_dump_json())
    assert ShirtLayout.model_validate(document).rings == {"cuff": [0, 1, 2, 3, 4]}
    assert "ring" not in sleeve(ring=False).model_dump_json()
    assert sleeve(sensors=2).rings == {}
    turned = json.loads(json.dumps(document))
    for i, channel in enumerate(turned["channels"]):
        channel["place"] = (i + 2) % 5
    assert ShirtLayout.model_validate(turned).rings == {"cuff": [3, 4, 0, 1, 2]}
    turned["channels"][0]["place"] = 3
    with pytest.raises(ValidationError, match="must be 0 to 4"):
        ShirtLayout.model_validate(turned)
    del turned["channels"][0]["ring"]
    with pytest.raises(ValidationError, match="a place but no ring"):
        ShirtLayout.model_validate(turned)


def test_documents_are_immutable(ten):
    for kind in (JointEntry, MomentsDocument, PersonEntry):
        assert kind.model_config["frozen"]
