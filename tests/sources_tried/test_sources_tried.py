"""What `make sources-tried` consists of, without a browser: the person, the far ends' numbers, film, table, page."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from sources_tried.figures import Course, Tried, likeness_of, row, section, section_of, with_section
from sources_tried.film import LEAN, Film, lean_angle, moved_points
from sources_tried.limbs import ARMS, device_angles_deg, orientations, sensor_angles_deg
from sources_tried.person import Eyes, ScriptedPerson
from sources_tried.sources import SOURCES

from app.cues import Cue
from app.hardware.base import BodyView
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM
from app.hardware.configs import KINDS
from app.hardware.shirt.orientation_sensors.orientation import angle_between, exponential
from app.hardware.shirt.orientation_sensors.phones import device_orientation
from app.hardware.shirt.orientation_sensors.witmotion import sensor_orientation
from app.source import NAMED_SHIRTS
from app.texts import Text

SIZE = (640, 480)
AT_REST = dict.fromkeys(("trunk", "head", "right_shoulder", "left_shoulder"), 0.0)
turns = st.tuples(*[st.floats(-0.8, 0.8)] * 3)


@given(turns)
def test_the_angles_of_a_device_and_of_a_sensor_are_those_of_its_orientation(vector):
    q = exponential(np.array(vector))
    assert angle_between(device_orientation(*device_angles_deg(q)), q) < 1e-6
    assert angle_between(sensor_orientation(*sensor_angles_deg(q)), q) < 1e-6


def test_a_bent_elbow_turns_its_forearm_alone():
    random = np.random.default_rng(1)
    at_rest = dict.fromkeys(ARM_DEGREES_OF_FREEDOM, 0.0)
    before = orientations(at_rest, random, 0.0)
    after = orientations({**at_rest, "left_elbow": 1.0}, random, 0.0)
    assert [part for part in ARMS if angle_between(before[part], after[part]) > 0.5] == ["left_forearm"]
    assert [part for part in ARMS if angle_between(before[part], after[part]) > 0.0] == ["left_forearm"]


def live_message(**fields):
    """Return what a message of the live socket has for the eyes, at rest."""
    rest = {"run": None, "trial": None, "state": "disarmed", "pose": [0.0, 0.0, 0.0], "v": 0.0, "omega": 0.0}
    return {**rest, "in_contact": False, "t": 1.0, "values": [0.0], "shirt": {"age": 0.02}, **fields}


def test_the_eyes_see_the_cue_of_the_joint_that_plays_and_a_metre_that_was_driven():
    cue = Cue(start=0.0, end=2.0, kind="move", joint="trunk")
    steps = [{"id": "a", "cues": []}, {"id": "b", "cues": [cue.model_dump(mode="json")]}]
    calibration = {"running": {"step": "b"}, "steps": steps}
    client = SimpleNamespace(get=lambda _path: SimpleNamespace(json=lambda: calibration))
    eyes = Eyes(SimpleNamespace(client=client, socket=lambda _name: ()), {"trunk": "right_elbow"})
    eyes.take(live_message(run={"kind": "prompt", "t": 0.5, "cue": 0}))
    assert eyes.view.cue == cue.model_copy(update={"joint": "right_elbow"})
    assert eyes.seen == [(1.0, [0.0])]
    eyes.take(live_message(run={"kind": "trial", "t": 0.5, "cue": None}, trial={"done": 0.5}, state="checking"))
    assert (eyes.view.cue, eyes.view.driving, eyes.ages) == (None, False, [])
    eyes.take(live_message(trial={"done": 0.99}, state="armed", pose=[1.0, 2.0, 0.5]))
    assert (eyes.view.driving, tuple(eyes.view.pose), eyes.ages) == (True, (1.0, 2.0, 0.5), [0.02])
    assert eyes.metre_t is None
    eyes.take(live_message(trial={"done": 1.01}, state="armed"))
    assert eyes.metre_t is not None


def test_the_person_moves_the_joint_that_the_cue_names_by_the_name_of_the_shirt():
    person = ScriptedPerson({"trunk": "right_elbow"})
    view = BodyView(cue=Cue(start=0.0, end=1.0, kind="move", joint="right_elbow"))
    levels = [person.levels(0.02, view) for _ in range(100)]
    assert max(level["trunk"] for level in levels) > 0.7
    assert max(level["left_elbow"] for level in levels) < 0.05
    assert set(levels[0]) == {*ARM_DEGREES_OF_FREEDOM, "trunk"}


@settings(max_examples=20)
@given(st.floats(0.0, 1.0), st.floats(-3.0, 3.0).filter(lambda slope: abs(slope) > 0.1))
def test_the_delay_and_the_slope_are_found(delay, slope):
    t = np.arange(0.0, 20.0, 0.01)
    values = np.sin(t) + 0.5 * np.sin(2.7 * t)
    seen_t = np.arange(2.0, 18.0, 0.05)
    seen = slope * np.interp(seen_t - delay, t, values)
    seen[::7] = math.nan
    found = likeness_of(Course(t.tolist(), values.tolist()), Course(seen_t.tolist(), seen.tolist()))
    assert found is not None
    assert found.delay == pytest.approx(delay, abs=0.0051)
    assert found.slope == pytest.approx(slope, rel=0.01)
    assert found.correlation == pytest.approx(math.copysign(1.0, slope), abs=1e-3)


def test_a_constant_course_follows_nothing():
    assert likeness_of(Course([0.0, 1.0], [0.0, 1.0]), Course([0.0, 1.0, 2.0], [3.0, 3.0, 3.0])) is None
    assert likeness_of(Course([], []), Course([0.0, 1.0, 2.0], [3.0, 4.0, 3.0])) is None


def test_a_lean_moves_the_upper_edge_and_leaves_the_lower_one():
    at_rest, leaning = moved_points(AT_REST, SIZE), moved_points({**AT_REST, "trunk": 1.0}, SIZE)
    middle = at_rest.shape[1] // 2
    assert at_rest[0, middle, 0] - leaning[0, middle, 0] == LEAN
    assert at_rest[-1, middle, 0] == leaning[-1, middle, 0]
    assert (at_rest[..., 1] == leaning[..., 1]).all()
    assert math.tan(lean_angle(1.0)) == pytest.approx(LEAN / SIZE[1])


def test_a_film_keeps_its_size_and_shows_the_posture(tmp_path):
    picture = Image.new("RGB", SIZE, (96, 96, 96))
    picture.paste((255, 255, 255), (312, 0, 328, SIZE[1]))  # an upright post
    file = tmp_path / "film.y4m"
    film = Film(file, picture)
    size = file.stat().st_size
    film.show({**AT_REST, "trunk": 1.0})
    film.close()
    content = file.read_bytes()
    head, _, planes = content.partition(b"\nFRAME\n")
    assert head.startswith(b"YUV4MPEG2 W640 H480 F30:1")
    assert len(planes) == SIZE[0] * SIZE[1] * 3 // 2
    assert len(content) == size
    luma = np.frombuffer(planes, np.uint8, SIZE[0] * SIZE[1]).reshape(SIZE[1], SIZE[0]).astype(float)
    post = [int(np.convolve(luma[y], np.ones(16), "same").argmax()) for y in (4, SIZE[1] // 2, SIZE[1] - 4)]
    assert post == pytest.approx([320 + LEAN, 320 + LEAN / 2, 320], abs=3)


def test_every_kind_that_somebody_wears_is_tried():
    forms = [kind.config.model_json_schema() for kind in KINDS if not kind.simulated]
    assert {form["title"] for form in forms} == {source.title for source in SOURCES}


@pytest.mark.parametrize("source", SOURCES, ids=lambda source: source.name)
def test_the_page_has_the_card_and_the_fields_of_a_source(source):
    forms = [kind.config.model_json_schema() for kind in KINDS]
    form = next(form for form in forms if form["title"] == source.title)
    labels = {field.get("title") for field in form["properties"].values()}
    assert {*source.fields, *source.places} <= labels
    assert source.recorded.partition(",")[0] in {str(Text(f"source-shirt-{name}")) for name in NAMED_SHIRTS}


def test_the_part_of_the_page_is_replaced_and_a_line_says_where_a_source_stopped():
    good = Tried("udp", 52, 14, 151.0, [0.01, 0.02], None, {"web": 0.1, "control": 0.2, "browser": 1.5})
    bad = Tried("camera", taps=3, stopped="source: 4 green lamps did not come | within 120 s")
    assert row(good) == "| udp | 52 | 14 | 151 | 15 | 20 | – | – | 10 | 20 | 150 | goal |\n"
    assert "**source: 4 green lamps did not come / within 120 s**" in row(bad)
    part = section([good, bad], ["lsl"], "1 May 2025", "abc", "a machine")
    page = with_section("# Drivers\nA table.\n", part)
    assert page.startswith("# Drivers\nA table.\n")
    assert "Not tried, without its library: lsl." in page
    assert section_of(page) == part
    assert with_section(page, section([good], [], "2 May 2025", "abd", "a machine")).count("# From") == 1
    assert section_of("# Drivers\n") == ""
