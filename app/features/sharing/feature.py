"""Review from elsewhere: what the feature gives to the rest of the program."""

from typing import TYPE_CHECKING, Final

from app.features.registration import Feature
from app.features.sharing.tables import ShareLink, ShareVisit

if TYPE_CHECKING:
    from app.api.parts import Parts


def add_parts(parts: "Parts") -> None:
    """Add what works out in which tasks a patient has become worse."""
    from app.computing_process import ComputingProcess
    from app.features.sharing.deteriorations import Deteriorations
    from app.session.clinic_spread import ClinicSpread
    from app.store.database import Database

    parts.add(Deteriorations, Deteriorations(parts[Database], parts[ComputingProcess], parts[ClinicSpread]))


FEATURE: Final = Feature(
    tables=(ShareLink, ShareVisit),
    routes=("attention", "stories", "routes", "shared_page"),
    add_parts=add_parts,
    not_archived={
        "share_link": "opens records of this clinic's machine, and belongs to who made it",
        "share_visit": "a browser in which a share link of this clinic was opened",
    },
)
