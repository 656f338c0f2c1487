"""Arming of the real chair: what it would apply, and the reasons that still refuse it."""

import asyncio
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from app.calibration.own_movement import own_movement_refusal
from app.calibration.vocabulary import DriveParameters, arming_hash
from app.refusals import Refusal
from app.session.chair_messages import CHAIR_FAULT, fault_sentence, is_silent
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.equipment.limits import ClinicLimits
from app.session.equipment.shirt import Equipment
from app.session.open_session import SessionFlow
from app.session.parameter_differences import Difference, differences
from app.source import SourceGroup
from app.speed_limits import HIGHEST_SPEEDS, Speeds, apply_dial, most_restrictive
from app.store.database import Database
from app.store.map_versions import source_of_map
from app.store.parameters import as_document, current_parameters, newest_profile
from app.store.patients import open_session
from app.store.practice import NO_PRACTICE, Practice, PracticeHistory
from app.store.tables import PatientSession
from app.texts import Text, text_of

NO_CHAIR = Text("drives-virtual-chair-chosen")
NOT_PRACTISED = Text("drives-not-practised")
SHOW_THE_SWITCH = Text("drives-show-the-switch")


@dataclass(frozen=True, slots=True)
class ArmingSummary:
    """Everything that a person reads before arming; what is not known is None."""

    session: PatientSession | None
    parameters_id: int | None
    parameters: DriveParameters | None
    speeds: Speeds | None  # the limits that would apply
    hash: str | None  # of the set and the chair document, with which the chair would be armed
    document: str  # the digits of the chair document as the chair tells them; empty: it has none
    crawls: bool  # whether the chair misses its document, and so drives at a crawl at most
    practice: Practice
    last_practised: DriveParameters | None
    differences: list[Difference]  # of `parameters` from `last_practised`
    refusals: list[Text | str]  # why the chair cannot be armed


@dataclass(frozen=True, slots=True)
class _StoredSet:
    """The open session and its current parameter set, as the database stores them."""

    session: PatientSession | None = None
    parameters_id: int | None = None
    parameters: DriveParameters | None = None
    calibrated: SourceGroup = "unknown"  # the group of the recordings that they were calibrated with
    practice: Practice = NO_PRACTICE
    last_practised: DriveParameters | None = None


class _ChairView(NamedTuple):
    """What the chosen chair says of itself."""

    refusals: list[Text | str]  # why it cannot be armed
    document: str = ""
    crawls: bool = False


class RealArming:
    """Checks everything that must be right before a real chair is armed; what cannot be checked refuses."""

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        equipment: Equipment,
        session: SessionFlow,
        chairs: Chairs,
        limits: ClinicLimits,
    ) -> None:
        self._database = database
        self._control = control
        self._equipment = equipment
        self._session = session
        self._chairs = chairs
        self._limits = limits
        self._practice = PracticeHistory()

    async def summary(self) -> ArmingSummary:
        """Return what arming would apply now."""
        stored = await asyncio.to_thread(self._read)
        parameters, last = stored.parameters, stored.last_practised
        changed = [] if parameters is None or last is None else differences(parameters, last)
        chair = await self._chair_view(parameters)
        return ArmingSummary(
            session=stored.session,
            parameters_id=stored.parameters_id,
            parameters=parameters,
            speeds=None if parameters is None else self._speeds(parameters),
            hash=None if parameters is None else arming_hash(parameters.hash, chair.document),
            document=chair.document,
            crawls=chair.crawls,
            practice=stored.practice,
            last_practised=last,
            differences=changed,
            refusals=[*self._patient_refusals(stored), *chair.refusals],
        )

    def lowered_speeds(self, speeds: Speeds) -> dict[str, float]:
        """Return, by name, the limits of the clinic or the chosen chair that are lower than those of `speeds`."""
        effective = self._without_dial(speeds).model_dump()
        return {name: value for name, value in effective.items() if value < getattr(speeds, name)}

    def _without_dial(self, speeds: Speeds) -> Speeds:
        chair = HIGHEST_SPEEDS if self._chairs.chosen is None else Speeds.model_validate(self._chairs.chosen.speeds)
        return most_restrictive(speeds, self._limits.speeds, chair)

    def _speeds(self, parameters: DriveParameters) -> Speeds:
        tick = self._control.newest()
        return apply_dial(self._without_dial(parameters.speeds), 1.0 if tick is None else float(tick["dial"]))

    def _patient_refusals(self, stored: _StoredSet) -> list[Text | str]:
        if stored.session is None:
            return [Text("visit-nobody")]
        if stored.parameters is None:
            return [Text("visit-not-calibrated")]
        refusals: list[Text | str] = []
        obstacle = self._session.obstacle(stored.parameters, stored.calibrated)
        if obstacle is not None:
            refusals.append(obstacle.sentence)
        if self._equipment.mistrust:
            refusals.append(self._equipment.mistrust)
        unconfirmed = own_movement_refusal(stored.parameters)
        if unconfirmed is not None:
            refusals.append(unconfirmed)
        if stored.practice.trials == 0:
            refusals.append(NOT_PRACTISED)
        return refusals

    async def _chair_view(self, parameters: DriveParameters | None) -> _ChairView:
        if self._chairs.chosen is None:
            return _ChairView([NO_CHAIR])
        refusal = self._chair_refusal(self._chairs.chosen.name, self._control.newest())
        if refusal:
            return _ChairView([refusal])
        try:
            chair = (await self._control.call("status"))["chair"]
        except Refusal as lost:
            return _ChairView([text_of(lost)])
        needs_switch = parameters is not None and parameters.keeps_speed and not chair.get("switch_seen")
        refusals: list[Text | str] = [SHOW_THE_SWITCH] if needs_switch else []
        return _ChairView(refusals, chair.get("document", ""), bool(chair.get("crawls")))

    def _chair_refusal(self, name: str, tick: np.void | None) -> Text | str | None:
        if tick is None:
            return Text("drives-wait-for-process")
        if not tick["chair_kind"]:
            return self._chairs.not_open
        if is_silent(tick):
            return Text("drives-chair-silent", name=name)
        if tick["stop_input"]:
            return Text("drives-stop-switch-pressed", name=name)
        return fault_sentence(int(tick["chair_fault"])) if int(tick["chair_state"]) == CHAIR_FAULT else None

    def _read(self) -> _StoredSet:
        group = self._equipment.group
        with self._database.reading() as db:
            session = open_session(db)
            if session is None or newest_profile(db, session.patient_id) is None:
                return _StoredSet(session)
            row, profile = current_parameters(db, session.patient_id)
            parameters = as_document(row, profile)
            return _StoredSet(
                session,
                row.id,
                parameters,
                source_of_map(db, profile),
                self._practice.practice(db, session.patient_id, parameters.hash, group),
                self._practice.newest(db, session.patient_id, group),
            )
