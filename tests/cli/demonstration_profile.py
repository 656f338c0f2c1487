"""Makes the profile of the demonstration's patient, by the program's calibration: `make shipped FILE=demo-profile`."""

from app.calibration.profile import CalibrationProfile
from app.cli.serve import profile_file
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.standard import standard_layout
from app.study.participant import Participant
from app.study.simulated_calibration import calibrate

SEED = 1  # of the fabric and the person: those of the simulated shirt and body that a control process starts with
SAMPLE_RATE = 100.0  # Hz


def calibrated() -> CalibrationProfile:
    """Return the profile of the simulated person, calibrated faster than real time."""
    return calibrate(Participant(SimulatedPerson(PRACTISED, SEED), standard_layout(), SAMPLE_RATE, SEED))


if __name__ == "__main__":
    profile_file().parent.mkdir(exist_ok=True)
    profile_file().write_text(calibrated().model_dump_json(indent=1) + "\n")
