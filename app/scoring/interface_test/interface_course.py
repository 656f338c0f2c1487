"""A person's interface tests over sessions: which of them count, their curves, and what has changed."""

from collections.abc import Sequence
from typing import NamedTuple

from app.json_values import JsonObject
from app.quantities import Document
from app.scoring.interface_test.interface_verdicts import InterfaceVerdicts, Tests, interface_verdicts
from app.scoring.learning_fit import fit_learning_curve
from app.scoring.measures import TEST_MEASURES, MeasureValues
from app.world.cursor_task import CursorPlan

COMPLETE = "complete"


class StoredTest(NamedTuple):
    """An interface test as it was stored."""

    number: int
    end: str | None
    plan: JsonObject  # of app.world.cursor_task.CursorPlan
    measures: MeasureValues | None  # None: the recording could not be read


class CurveBand(Document):
    """A fitted learning curve with its 95 % band, at the numbers of the tests."""

    n: list[float]
    value: list[float]
    low: list[float]
    high: list[float]


class InterfaceCourse(Document):
    """What a person's tests of one plan and one kind of source say together."""

    counted: list[int]  # numbers of the tests that count
    curves: dict[str, CurveBand]  # measure -> curve; only of those that a bent curve describes better than a level line
    comparisons: list[InterfaceVerdicts]  # of the newest test that counts


def counted_tests(tests: Sequence[StoredTest]) -> list[MeasureValues]:
    """Return number and measures of the complete tests that asked the same as the newest of them; keep the order."""
    complete = [test for test in tests if test.end == COMPLETE and test.measures is not None]
    plans = [CursorPlan.model_validate(test.plan) for test in complete]
    return [
        {"number": test.number, **(test.measures or {})}
        for test, plan in zip(complete, plans, strict=True)
        if plan.same_task(plans[-1])
    ]


def interface_course(tests: Tests) -> InterfaceCourse:
    """Return the course of complete tests, in the order done; each has `number` and its measures by name."""
    curves = {}
    for name in TEST_MEASURES:
        measured = [(float(test["number"]), float(test[name])) for test in tests if test.get(name) is not None]
        fitted = fit_learning_curve([number for number, _ in measured], [value for _, value in measured])
        if fitted is not None and fitted.curve.form != "level":
            curve = fitted.curve
            lists = {"value": curve.value, "low": curve.low, "high": curve.high}
            curves[name] = CurveBand(n=fitted.n.tolist(), **{key: column.tolist() for key, column in lists.items()})
    counted = [int(test["number"]) for test in tests]
    return InterfaceCourse(counted=counted, curves=curves, comparisons=interface_verdicts(tests))
