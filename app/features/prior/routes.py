"""The owner's switch of the clinic's prior: whether accepted calibrations help later patients."""

from fastapi import APIRouter

from app.api.deps import Anyone, Db, EquipmentPart, LivePart, Owner
from app.api.page_session import OF_CLINIC, any_session
from app.calibration.prior.documents import FEWEST_PEOPLE
from app.features.prior.entries import count_entries, is_prior_on, switch_prior
from app.news import News
from app.quantities import Document
from app.session.calibration.calibration_fit import garment
from app.session.equipment.shirt import Equipment
from app.store.database import Transaction
from app.store.log import write_log

router = APIRouter(prefix="/clinic-prior", tags=["calibration"])


class PriorChoice(Document):
    """Whether the clinic learns from its accepted calibrations."""

    on: bool


class PriorView(Document):
    """The switch, and what it has brought so far."""

    on: bool
    people: int  # of this clinic, whose movements in the shirt in use are known
    needed: int  # people from whom on a new patient can drive before being calibrated


@router.get("")
def read_prior(_person: Anyone, database: Db, equipment: EquipmentPart) -> PriorView:
    """Return the switch, and how many people are known in the shirt in use."""
    with database.reading() as db:
        return _view(db, equipment)


@router.put("")
@any_session(OF_CLINIC)
def choose(body: PriorChoice, person: Owner, database: Db, equipment: EquipmentPart, live: LivePart) -> PriorView:
    """Switch it on or off; what was learnt before stays, and helps again when it is switched on."""
    with database.transaction() as db:
        if switch_prior(db, on=body.on):
            write_log(db, person.name, "prior switched", on=body.on)
        answer = _view(db, equipment)
    live.notify(News(what="calibration"))
    return answer


def _view(db: Transaction, equipment: Equipment) -> PriorView:
    layout = equipment.layout
    shirt = None if layout is None else garment(layout, equipment)
    people = 0 if shirt is None else count_entries(db, shirt.hash, simulated=shirt.simulated)
    return PriorView(on=is_prior_on(db), people=people, needed=FEWEST_PEOPLE)
