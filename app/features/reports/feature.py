"""Reports: what the feature gives to the rest of the program."""

from typing import TYPE_CHECKING, Final

from app.features.registration import Feature

if TYPE_CHECKING:
    from app.features.registration import MakeReport
    from app.scoring.verdict.spread import SpreadsOf
    from app.settings import Settings
    from app.store.database import Database


def report(database: "Database", settings: "Settings", patient_id: int, spreads_of: "SpreadsOf") -> "MakeReport | None":
    """Return what makes the report of a patient's course for an archive, None without a session."""
    from app.features.reports.service import report_of_archive

    return report_of_archive(database, settings, patient_id, spreads_of)


FEATURE: Final = Feature(routes=("routes",), report=report)
