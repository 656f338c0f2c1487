import json

import pytest
from cli.answers import invoke
from cli.conftest import write_shirt
from cli.symbols import symbols_in

from app.calibration.profile import CalibrationProfile
from app.cli.calibration.calibrate import calibrate
from app.cli.errors import InputError

STROKES = {"right_elbow": (4.0, 8.0, 12.0), "left_elbow": (6.0, 10.0, 14.0)}  # s: when each elbow bends for 1 s


@pytest.fixture
def files(tmp_path):
    """Sixteen seconds of two elbows that bend in turn, on six channels of which some fall when the elbow bends."""
    write_shirt(tmp_path, "elbows", STROKES, ((-1.0, -0.5, 0.2), (0.8, 0.3, -0.6)), seconds=16, seed=1, form="%.5f")
    return tmp_path


def run(files, *more):
    words = ("--layout", files / "layout.json", "--out", files / "profile.json", *more)
    return invoke("calibrate", files / "signals.csv", *words)


def test_json_is_one_object_with_the_names_that_others_rely_on(files):
    result = run(files, "--prompts", str(files / "prompts.csv"), "--rest-from", "0", "--rest-to", "3", "--json")
    assert result.exit_code == 0, result.output
    answer = json.loads(result.stdout)
    assert set(answer) == {"dialect", "joints", "maps", "profile"}
    assert answer["dialect"] == {"separator": ",", "decimal": "."}
    profile = CalibrationProfile.model_validate_json((files / "profile.json").read_bytes())
    assert answer["profile"] == str(files / "profile.json")
    for joint in profile.joints:
        shown = answer["joints"][joint.name]
        assert set(shown) == {"evr", "span", "has_to_be_repeated", "reason", "dead_zone", "full"}
        assert shown["has_to_be_repeated"] is False, shown["reason"]
        assert shown["evr"] > 0.95
        # The first channel of the right elbow falls when it bends, that of the left one rises.
        assert joint.direction[0] * (-1 if joint.name == "right_elbow" else 1) > 0


def test_people_get_a_table_and_the_reasons(files):
    result = run(files, "--from", "3", "--to", "16", "--unused", "left_elbow_1", "--unused", "left_elbow_2")
    assert result.exit_code == 0, result.output
    for words in (
        "clear",
        "counts from",
        "right_elbow: It was not prompted",
        "left_elbow_1 is left out: marked as unused",
    ):
        assert words in result.output
    assert symbols_in(result.output) == []


def test_gestures_are_ranked_there_and_back(files):
    windows = ("--prompts", str(files / "prompts.csv"), "--rest-from", "0", "--rest-to", "3", "--gestures")
    found = json.loads(run(files, *windows, "--json").stdout)["gestures"]
    assert found["source"] == "recordings"
    assert {(one["joint"], one["direction"]) for one in found["gestures"]} == {
        (joint, way) for joint in ("right_elbow", "left_elbow") for way in (1, -1)
    }
    assert [binding["control"] for binding in found["suggestion"]["bindings"]] == ["u1+", "u1-", "stop"]
    table = run(files, *windows).output
    assert "left_elbow_back" in table
    assert symbols_in(table) == []
    assert found["suggestion"]["reason"] in table
    assert "gestures" not in json.loads(run(files, "--json").stdout)


def test_a_joint_without_channels_is_there_with_its_reason(files):
    unused = [word for i in range(3) for word in ("--unused", f"left_elbow_{i}")]
    answer = json.loads(run(files, *unused, "--json").stdout)
    assert answer["joints"]["left_elbow"]["has_to_be_repeated"] is True
    assert answer["joints"]["left_elbow"]["evr"] is None
    assert "left_elbow" in run(files, *unused).output


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"layout": "nothing.json"}, "no such layout"),
        ({"signals": "layout.json"}, "line 1"),
        ({"prompts": "signals.csv"}, "none of the columns end, joint, start"),
        ({"start": 20.0}, "--from 20 --to 15.99: nothing of .* lies there, it goes from 0 to 15.99 s"),
        ({"start": 5.0, "end": 4.0}, "--from 5 --to 4: nothing"),
        ({"start": float("nan")}, "--from nan"),
        ({"start": 5.0, "end": 5.5}, "the free movement lasts 0.50 s"),
        ({"rest_start": 3.0, "rest_end": 3.1}, "the rest lasts 0.10 s"),
        ({"unused": ["nothing"]}, "no channel 'nothing'"),
        ({"out": "layout.json/profile.json"}, "--out .* cannot be written"),
    ],
)
def test_bad_input_is_one_sentence_and_nothing_is_written(files, changes, words):
    given = {"signals": "signals.csv", "layout": "layout.json", "out": "profile.json", **changes}
    given = {name: files / word if isinstance(word, str) else word for name, word in given.items()}
    with pytest.raises(InputError, match=words) as refusal:
        calibrate(given.pop("signals"), **given)
    assert "\n" not in str(refusal.value)
    assert sorted(file.name for file in files.iterdir()) == ["layout.json", "prompts.csv", "signals.csv"]


def test_what_a_spreadsheet_writes_is_read_and_told(files):
    plain = json.loads(run(files, "--prompts", str(files / "prompts.csv"), "--json").stdout)
    for name in ("signals.csv", "prompts.csv"):
        written = (files / name).read_text()
        (files / name).write_text(written.replace(",", ";").replace(".", ","))
    result = run(files, "--prompts", str(files / "prompts.csv"), "--json")
    assert result.exit_code == 0, result.output
    found = json.loads(result.stdout)
    assert found.pop("dialect") == {"separator": ";", "decimal": ","}
    assert plain.pop("dialect") == {"separator": ",", "decimal": "."}
    assert found == plain
    assert "read with semicolons between columns and decimal commas" in run(files).output


@pytest.mark.parametrize("prompted", [True, False])
def test_the_table_says_what_is_expected_of_the_person_s_own_calibration(files, prompted):
    words = ["--rest-from", "0", "--rest-to", "3", *(["--prompts", str(files / "prompts.csv")] if prompted else [])]
    said = run(files, *words).stdout
    row = next(line for line in said.splitlines() if line.startswith("right_elbow "))
    assert "grade" not in said
    assert ("at least" in row, "at most" in row) == (prompted, prompted)
    assert row.count("not known") == (0 if prompted else 2)
