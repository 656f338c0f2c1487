"""Controls saved by an earlier version of the program: read, or refused in a sentence."""

from typing import Any

from sqlalchemy import select

from app.session.open_session import SessionFlow
from app.store.tables import ParameterSet

WITH_A_JOINER = "\U0001f469\u200d\U0001f9bd slow"  # a woman in a wheelchair: names of before could hold any character


def change_saved(clinic: Any, **settings: Any) -> None:
    clinic.good("GET", "/controls")
    with clinic.database.transaction() as db:
        for row in db.scalars(select(ParameterSet)):
            row.settings = {**row.settings, **settings}


def test_a_title_that_could_not_be_typed_any_more_is_still_read(calibrated: Any) -> None:
    change_saved(calibrated, title=WITH_A_JOINER)
    controls = calibrated.good("GET", "/controls")
    assert controls["parameters"]["title"] == WITH_A_JOINER
    calibrated.good("PUT", "/equipment/unused", json={"channels": []})


def test_a_set_that_cannot_be_read_is_a_sentence_and_keeps_nobody_from_anything_else(calibrated: Any) -> None:
    change_saved(calibrated, of_another_program=1)
    assert "another version" in calibrated.refused(409, "GET", "/controls")
    calibrated.good("PUT", "/equipment/unused", json={"channels": []})
    session = calibrated.parts[SessionFlow]
    calibrated.client.portal.call(session.session_changed)  # as at the start of the program
    assert session.loaded is None
