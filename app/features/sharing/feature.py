"""Review from elsewhere: what the feature gives to the rest of the program."""

from typing import Final

from app.features.registration import OWN_NAME, Feature
from app.features.sharing.tables import ShareLink, ShareVisit

FEATURE: Final = Feature(
    tables=(ShareLink, ShareVisit),
    routes=("attention", "stories", "routes", "shared_page"),
    without_session={
        "POST /patients/{patient_id}/shares": OWN_NAME,
        "POST /sessions/{session_id}/shares": OWN_NAME,
        "DELETE /shares/{share_id}": OWN_NAME,
        "POST /shared/open": "It reads what one link shares, and changes nothing of a session.",
    },
    not_archived={
        "share_link": "opens records of this clinic's machine, and belongs to who made it",
        "share_visit": "a browser in which a share link of this clinic was opened",
    },
)
