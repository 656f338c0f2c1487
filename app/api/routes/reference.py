"""What pages look up: the catalogue of measures."""

from fastapi import APIRouter

from app.api.deps import ForEveryone
from app.quantities import Document
from app.scoring.measures import (
    LEADING,
    LEADING_OF_TESTS,
    REACHED_NAME,
    TEST_MEASURES,
    TRIAL_MEASURES,
    VERDICT_WORDS,
    VERDICT_WORDS_OF_TESTS,
    WORKLOAD_NAME,
    Measure,
    Word,
)

router = APIRouter(tags=["start"])


class LeadingMeasures(Document):
    """The measures that lead in a task whose trials have all measures of `has`."""

    has: list[str]
    names: list[str]


class MeasureCatalogue(Document):
    """The measures of trials and of two-minute tests by their keys, in the order in which pages show them."""

    trial: dict[str, Measure]
    test: dict[str, Measure]
    leading: list[LeadingMeasures]  # the first row that fits holds
    leading_of_tests: list[str]
    reached: str  # what people call the share of trials that reached the goal
    workload: str  # what people call the mean of the answers after a two-minute test
    verdicts: dict[Word, str]  # on trials
    verdicts_of_tests: dict[Word, str]


class Reference(Document):
    """Facts of the program that stay as they are while it runs."""

    measures: MeasureCatalogue


@router.get("/reference", dependencies=[ForEveryone])
def reference() -> Reference:
    """Return the facts that pages need beside data: they have no tables of their own."""
    return Reference(
        measures=MeasureCatalogue(
            trial=TRIAL_MEASURES,
            test=TEST_MEASURES,
            leading=[LeadingMeasures(has=list(has), names=list(names)) for has, names in LEADING],
            leading_of_tests=list(LEADING_OF_TESTS),
            reached=REACHED_NAME,
            workload=WORKLOAD_NAME,
            verdicts=VERDICT_WORDS,
            verdicts_of_tests=VERDICT_WORDS_OF_TESTS,
        )
    )
