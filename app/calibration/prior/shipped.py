"""The priors that ship with the program: of simulated people in a simulated shirt."""

from functools import cache
from pathlib import Path

from app.calibration.prior.documents import ReleasedPrior
from app.calibration.prior.map_prior import layout_key
from app.calibration.prior.prior_file import read_prior
from app.layout import ShirtLayout
from app.settings import data_folder

SHIPPED_SEED = 1  # of the simulated shirt that a prior ships for, which is the one that a clinic begins with


def priors_folder() -> Path:
    """Return the folder of the priors that ship with the program; `make shipped FILE=prior` writes them."""
    return data_folder() / "priors"


def shipped_prior(layout: ShirtLayout) -> ReleasedPrior | None:
    """Return the prior that ships for the simulated shirt of this layout and of SHIPPED_SEED; None when there is none.

    Layouts are alike when their channels and joints are; one may name rings that the other does not.
    """
    return _shipped_priors(priors_folder()).get(layout_key(layout))


@cache
def _shipped_priors(folder: Path) -> dict[tuple[tuple[str, str], ...], ReleasedPrior]:
    priors = [read_prior(file) for file in sorted(folder.glob("*.json"))]
    return {layout_key(prior.layout): prior for prior in priors if isinstance(prior, ReleasedPrior)}
