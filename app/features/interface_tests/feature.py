"""The two-minute test before driving: what the feature gives to the rest of the program.

What was tested is kept in the kernel (`InterfaceTest`), beside trials and drives: records, reports, exports and
archives hold it.
"""

from typing import TYPE_CHECKING, Any, Final

from app.features.registration import Feature

if TYPE_CHECKING:
    from app.computing_process import ComputingProcess
    from app.news import Notify
    from app.session.control_link import ControlLink
    from app.session.run_flow import RunFlow
    from app.session.runs import SessionRuns
    from app.store.database import Database


def flow(
    database: "Database",
    control: "ControlLink",
    runs: "SessionRuns",
    notify: "Notify",
    computing: "ComputingProcess",
) -> "RunFlow[Any]":
    """Return what starts a test and follows it to its measures."""
    from app.features.interface_tests.flow import InterfaceTestFlow

    return InterfaceTestFlow(database, control, runs, notify, computing)


FEATURE: Final = Feature(routes=("routes",), flow=flow)
