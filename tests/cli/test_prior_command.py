"""`bodydrive prior` and `calibrate --prior`: from files of other people to a profile that decodes."""

import json

import numpy as np
import pytest
from calibration.prior.simulated_wearers import Wearer, sleeve
from cli.answers import invoke
from cli.symbols import symbols_in

from app.calibration.prior.documents import ReleasedPrior
from app.calibration.prior.prior_file import read_prior
from app.calibration.profile import CalibrationProfile
from app.cli.errors import InputError
from app.number_format import percent


def refusal(result):
    assert result.exit_code != 0
    assert isinstance(result.exception, InputError)
    return str(result.exception)


def write(folder, name, wearer, values=None, until=None):
    """Write signals with a column that the layout does not have, and the prompts that end before `until` (s)."""
    table = np.column_stack((wearer.t, wearer.values if values is None else values, 90 * wearer.angle))
    np.savetxt(folder / f"{name}.csv", table, delimiter=",", header="t,e0,e1,e2,e3,e4,angle_deg", comments="")
    rows = ["start,end,joint"]
    for (start, stop), lead in zip(wearer.strokes, wearer.lead, strict=True):
        if until is None or stop / wearer.rate < until:
            rows.append(f"{start / wearer.rate - lead:.3f},{stop / wearer.rate - lead:.3f},right_elbow")
    (folder / f"{name}-prompts.csv").write_text("\n".join(rows) + "\n")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Files of nine people, and a prior of eight of them."""
    folder = tmp_path_factory.mktemp("sleeve")
    (folder / "layout.json").write_text(sleeve().model_dump_json())
    for seed in range(1, 9):
        write(folder, f"w{seed}", Wearer(seed))
        assert add(folder, f"w{seed}").exit_code == 0
    write(folder, "new", Wearer(102), until=20.0)
    return folder


def add(folder, name, person=None, prior="prior.json", more=()):
    return invoke(
        "prior", "add", folder / prior, folder / f"{name}.csv", "--layout", folder / "layout.json",
        "--prompts", folder / f"{name}-prompts.csv", "--person", person or name, *more,
    )  # fmt: skip


def calibrate(folder, *words, signals="new"):
    return invoke(
        "calibrate", folder / f"{signals}.csv", "--layout", folder / "layout.json", "--out", folder / "profile.json",
        "--from", 0, "--to", 10, "--prior", folder / "prior.json", *words,
    )  # fmt: skip


def decoded_share(folder):
    """Return the share of the activation that lies in the true strokes, as `decode` writes it."""
    result = invoke("decode", folder / "new.csv", "--profile", folder / "profile.json", "--out", folder / "out.csv")
    assert result.exit_code == 0, result.output
    activation = np.genfromtxt(folder / "out.csv", delimiter=",", names=True)["right_elbow_activation"]
    moving = np.roll(Wearer(102).moving, 5)
    return activation[moving].sum() / activation.sum()


def test_a_person_is_added_replaced_and_removed(folder):
    for expected in ("added", "replaced"):
        result = add(folder, "w1", "somebody", "few.json", ["--json"])
        assert result.exit_code == 0, result.output
        answer = json.loads(result.stdout)
        assert answer["replaced"] is (expected == "replaced")
        assert answer["people"] == 1
    before = (folder / "few.json").read_bytes()
    assert add(folder, "w2", "another", "few.json").exit_code == 0
    assert invoke("prior", "remove", folder / "few.json", "--person", "another").exit_code == 0
    assert (folder / "few.json").read_bytes() == before
    assert "no person 'another'" in refusal(invoke("prior", "remove", folder / "few.json", "--person", "another"))


def test_all_recordings_of_a_person_are_given_at_once(folder):
    result = invoke(
        "prior", "add", folder / "both.json", folder / "w1.csv", folder / "w2.csv", "--layout", folder / "layout.json",
        "--prompts", folder / "w1-prompts.csv", "--prompts", folder / "w2-prompts.csv", "--person", "p1", "--json",
    )  # fmt: skip
    assert result.exit_code == 0, result.output
    assert json.loads(result.stdout)["recordings"] == 2


def test_what_a_prior_knows_is_shown(folder):
    answer = json.loads(invoke("prior", "show", folder / "prior.json", "--json").stdout)
    joint = answer["joints"]["right_elbow"]
    assert (answer["kind"], joint["people"], answer["rings"]) == ("own", 8, {"cuff": 8})
    assert set(joint["ranges"]) == {f"e{i}" for i in range(5)}
    assert joint["strokes"] == sum(len(Wearer(seed).strokes) for seed in range(1, 9))
    rates = joint["stroke_rates"]
    assert 0.2 < rates["counts_from"] < rates["mean"] < 1.0
    assert rates["deviation"] > 0.05
    table = invoke("prior", "show", folder / "prior.json").stdout
    assert f"{percent(rates['mean'])} ± {percent(rates['deviation'])}" in table
    assert "8 people in 'sleeve'" in table
    assert symbols_in(table) == []


def test_a_release_is_a_sum_over_eight(folder):
    result = invoke("prior", "merge", folder / "prior.json", "--out", folder / "release.json")
    assert result.exit_code == 0, result.output
    assert isinstance(read_prior(folder / "release.json"), ReleasedPrior)
    again = invoke("prior", "merge", folder / "prior.json", "--out", folder / "no.json")
    assert "use the earlier release" in refusal(again)  # nobody is in two
    assert not (folder / "no.json").exists()
    assert add(folder, "w1", "p1", "seven.json").exit_code == 0
    words = refusal(invoke("prior", "merge", folder / "seven.json", "--out", folder / "no.json"))
    assert "at least 8 people may leave a clinic" in words
    assert not (folder / "no.json").exists()
    own = invoke("prior", "merge", folder / "seven.json", folder / "prior.json", "--own", "--out", folder / "own.json")
    assert own.exit_code == 0, own.output
    assert len(read_prior(folder / "own.json").people) == 9
    twice = invoke("prior", "merge", folder / "prior.json", folder / "prior.json", "--out", folder / "no.json")
    assert "stands there twice" in refusal(twice)
    assert "is a release" in refusal(add(folder, "w1", "p1", "release.json"))


@pytest.mark.parametrize("prompted", [False, True])
def test_somebody_new_drives_with_the_profile(folder, prompted):
    own = ["--prompts", folder / "new-prompts.csv"] if prompted else []
    result = calibrate(folder, *own, "--map", "prior", "--json")
    assert result.exit_code == 0, result.output
    answer = json.loads(result.stdout)
    facts = answer["prior"]["right_elbow"]
    assert answer["arrangement"] == {"cuff": {"shift": 0, "mirrored": False}}
    assert facts["people"] == 8
    assert facts["source"] == ("from other people and own movement" if prompted else "from other people")
    assert facts["hits_of_100"]["uncertainty"] > 0
    assert (facts["false_per_minute"] == "not known") is not prompted
    profile = CalibrationProfile.model_validate_json((folder / "profile.json").read_bytes())
    assert profile.joints[0].map == "prior"
    assert answer["joints"]["right_elbow"]["dead_zone"] == profile.joints[0].thresholds[0]
    assert decoded_share(folder) > 0.9


def test_a_turned_shirt_and_a_dead_channel_are_named(folder):
    values = np.roll(Wearer(102).values, 1, axis=1)
    write(folder, "turned", Wearer(102), values)
    answer = json.loads(calibrate(folder, "--map", "prior", "--json", signals="turned").stdout)
    assert answer["arrangement"] == {"cuff": {"shift": 1, "mirrored": False}}
    words = calibrate(folder, "--map", "prior", signals="turned").stdout
    assert "turned by 1 place against other people" in words
    assert symbols_in(words) == []
    still = Wearer(102).values.copy()
    still[:, 2] = still[0, 2] + 0.03 * (still[:, 2] - still[0, 2])
    write(folder, "still", Wearer(102), still)
    assert json.loads(calibrate(folder, "--json", signals="still").stdout)["prior"]["right_elbow"]["dropped"] == ["e2"]


def test_the_best_map_is_other_people_s_until_own_repetitions_say_that_it_answers_less(folder):
    """The movement of this sleeve is one direction: its standard map is in phase, and has a dead-zone of its own."""
    write(folder, "early", Wearer(102), until=7.0)
    for prompts, best in (("early", "prior"), ("new", "pca")):
        assert calibrate(folder, "--prompts", folder / f"{prompts}-prompts.csv", "--map", "best").exit_code == 0
        assert CalibrationProfile.model_validate_json((folder / "profile.json").read_bytes()).joints[0].map == best
    assert decoded_share(folder) > 0.95


def test_bad_input_is_one_sentence(folder, tmp_path):
    layout = folder / "layout.json"
    calibrated = invoke("calibrate", folder / "new.csv", "--layout", layout, "--out", tmp_path / "p", "--map", "prior")
    assert "give it with --prior" in refusal(calibrated)
    (tmp_path / "bad.json").write_text("{}")
    assert "bad.json" in refusal(invoke("prior", "show", tmp_path / "bad.json"))
    assert "no such prior" in refusal(invoke("prior", "show", tmp_path / "none.json"))
    assert "letters, digits" in refusal(add(folder, "w1", "two words", "x.json"))
    assert "1 recordings and 2 tables" in refusal(
        add(folder, "w1", "p", "x.json", ["--prompts", folder / "w2-prompts.csv"])
    )
    few = invoke(
        "calibrate", folder / "new.csv", "--layout", layout, "--out", tmp_path / "p", "--map", "prior",
        "--prior", folder / "few.json",
    )  # fmt: skip
    assert "1 of them is known for this joint, and 4 are needed" in refusal(few)
    (tmp_path / "other.json").write_text(sleeve().model_dump_json().replace("right_elbow", "left_elbow"))
    other = invoke(
        "calibrate", folder / "new.csv", "--layout", tmp_path / "other.json", "--out", tmp_path / "p",
        "--prior", folder / "prior.json",
    )  # fmt: skip
    assert "each shirt needs a prior of its own" in refusal(other)
    assert not (folder / "x.json").exists()
    assert not (tmp_path / "p").exists()


@pytest.mark.parametrize("prompted", [True, False])
def test_the_table_of_a_calibration_says_what_is_expected_and_what_is_not_known(folder, prompted):
    words = ["--prompts", folder / "new-prompts.csv"] if prompted else []
    said = calibrate(folder, *words, "--map", "prior").stdout
    row = next(line for line in said.splitlines() if line.startswith("right_elbow "))
    assert "grade" not in said
    assert ("not known" in row) is not prompted  # false activations without any prompt
    profile = CalibrationProfile.model_validate_json((folder / "profile.json").read_bytes())
    hits = profile.joints[0].prior.hits
    assert f"{hits.value:.0f} ± {hits.uncertainty:.0f}" in row
    assert symbols_in(said) == []
