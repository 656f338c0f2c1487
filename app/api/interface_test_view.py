"""A two-minute test as it is answered: on its own page, in the record of a session, in a comparison of two."""

from app.api.answers import MomentText
from app.api.routes.source_view import SourceView
from app.quantities import Document
from app.scoring.interface_test.interface_measures import InterfaceMeasures
from app.scoring.interface_test.workload import Workload
from app.store.tables import InterfaceTest


class InterfaceTestView(Document):
    """An interface test."""

    id: int
    number: int
    session_id: int
    session: int  # number of the session
    started: MomentText
    status: str
    end: str | None  # complete, by hand, stopped, fault
    source: SourceView
    measures: InterfaceMeasures | None  # None while it runs, or when the recording cannot be read
    workload: Workload | None
    raw_tlx: float | None  # mean of the six answers; None when one was left out

    @classmethod
    def of_row(cls, test: InterfaceTest, session: int) -> "InterfaceTestView":
        """Return the view of a row; `session` is the number of its session."""
        workload = None if test.workload is None else Workload.model_validate(test.workload)
        return cls(
            id=test.id,
            number=test.number,
            session_id=test.session_id,
            session=session,
            started=test.started.isoformat(),
            status=test.status,
            end=test.end,
            source=SourceView.model_validate(test.source),
            measures=None if test.measures is None else InterfaceMeasures.model_validate(test.measures),
            workload=workload,
            raw_tlx=None if workload is None else workload.raw_tlx,
        )
