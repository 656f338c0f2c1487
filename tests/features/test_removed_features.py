"""Each feature can go: without its line and its folder the program runs, and answers all else as before."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from itertools import product

import pytest
from features.without_feature import HIDDEN, WHOLE
from rules.test_imports import feature_of, imports_of_all

from app.cli.calibration.prior_command import prior_app
from app.cli.main import COMMANDS, OF_FEATURES
from app.features import NEEDS
from app.features.registration import features
from folders import ROOT

# Commands of the kernel that add commands of a feature themselves, when it is there.
ADDS = {"prior": "prior"}
ENVIRONMENT = os.environ | {"PYTHONPATH": os.pathsep.join(str(ROOT / part) for part in ("", "tests"))}
ENDS = ("DELETE /session", "DELETE /patients/1", "POST /deleted-patients/1/erasure")


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], dict[str, int]]:
    """Return a function that returns the status of each answer of a program without some features."""
    folder = tmp_path_factory.mktemp("features")
    command = [sys.executable, "-m", "features.without_feature", str(folder)]
    ended = subprocess.run(command, cwd=ROOT, env=ENVIRONMENT, check=False, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr

    def of(name: str) -> dict[str, int]:
        found = json.loads((folder / f"{name}.json").read_text())
        assert isinstance(found, dict), found
        return found

    return of


@pytest.fixture(scope="module")
def with_all(answers: Callable[[str], dict[str, int]]) -> dict[str, int]:
    return answers(WHOLE)


def test_the_program_answers_while_all_features_are_there(with_all: dict[str, int]) -> None:
    assert {request: status for request, status in with_all.items() if status >= 500} == {}
    assert [with_all[request] for request in ENDS] == [200, 200, 200]
    pages = [status for request, status in with_all.items() if request.endswith(".html")]
    assert set(pages) == {200}


def test_each_feature_is_hidden_while_each_other_one_that_does_not_need_it_is_there() -> None:
    left_out = [{name for name, needs in NEEDS.items() if {name, *needs} & set(hidden)} for hidden in HIDDEN]
    apart = {(one, other) for names in left_out for one, other in product(names, NEEDS.keys() - names)}
    assert apart == {(one, other) for one, other in product(NEEDS, NEEDS) if one not in {other, *NEEDS[other]}}


@pytest.mark.parametrize("number", range(len(HIDDEN)))
def test_the_program_runs_without_some_features(
    number: int, with_all: dict[str, int], answers: Callable[[str], dict[str, int]]
) -> None:
    without = answers(str(number))
    if "backup" in HIDDEN[number]:  # its page is where an owner erases now; who is due is erased without it, too
        del without[ENDS[2]]
    refused = {409} if "consents" in HIDDEN[number] else set()  # nobody has consented to anything
    assert {
        request: (status, with_all[request])
        for request, status in without.items()
        if status not in {with_all[request], *refused}
    } == {}


@pytest.mark.parametrize("name", NEEDS)
def test_the_routes_of_a_feature_go_with_it(
    name: str, with_all: dict[str, int], answers: Callable[[str], dict[str, int]]
) -> None:
    runs = [answers(str(number)) for number, hidden in enumerate(HIDDEN) if name in hidden]
    gone = with_all.keys() - {request for run in runs for request in run}
    assert bool(gone) == any(one.routes for other, one in features().items() if name in {other, *NEEDS[other]})


def test_a_command_that_imports_a_feature_goes_with_it() -> None:
    uses = {word: {*map(feature_of, imports_of_all()[module])} - {""} for word, (module, *_) in COMMANDS.items()}
    assert {word: found for word, found in uses.items() if found - {OF_FEATURES.get(word), ADDS.get(word)}} == {}
    assert OF_FEATURES.keys() <= COMMANDS.keys()


def test_the_command_of_priors_adds_those_of_the_clinic_with_the_feature() -> None:
    code = """if True:
        from features.without_feature import hide
        hide("prior")
        from app.cli.calibration.prior_command import prior_app
        print(*(command.name for command in prior_app.registered_commands))
    """
    ended = subprocess.run([sys.executable, "-c", code], env=ENVIRONMENT, check=True, capture_output=True, text=True)
    without = set(ended.stdout.split())
    assert {str(command.name) for command in prior_app.registered_commands} - without == {"export", "import"}
