"""The shirt of the paper: 52 channels over shoulders, elbows and wrists."""

from pydantic import ValidationError

from app.hardware.base import HardwareError
from app.layout import ShirtLayout
from app.sentences import one_sentence
from app.settings import data_folder
from app.texts import Text

STANDARD_SHIRT = "bodydrive-52.json"


def standard_layout() -> ShirtLayout:
    """Return the layout that is installed with the application.

    Raises
    ------
    HardwareError
        When its file is missing or broken, so that the installation is incomplete.
    """
    file = data_folder() / "shirts" / STANDARD_SHIRT
    try:
        return ShirtLayout.model_validate_json(file.read_bytes())
    except OSError as error:
        raise HardwareError(Text("shirtdev-no-standard", file=str(file), why=error.strerror or "")) from error
    except ValidationError as error:
        raise HardwareError(one_sentence(error, str(file))) from error
