"""Makes the prior that ships with the simulated shirt, of simulated people: `make shipped FILE=prior`."""

from app.calibration.prior.release import release
from app.calibration.prior.shipped import priors_folder
from app.hardware.shirt.standard import standard_layout
from app.study.simulated_calibration import prior_of_wearers

SEEDS = range(90_001, 90_017)  # no demonstration and no study has such a seed


def released() -> str:
    """Return the document of the prior."""
    return release([prior_of_wearers(standard_layout(), SEEDS)]).document.model_dump_json() + "\n"


if __name__ == "__main__":
    priors_folder().mkdir(exist_ok=True)
    (priors_folder() / f"{standard_layout().name.replace(' ', '-')}.json").write_text(released())
