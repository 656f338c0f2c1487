"""The time line of a trial, for its replay; shown while somebody drives, too: another process reads the recording."""

import gzip

from fastapi import APIRouter, Request, Response

from app.api.deps import Anyone, Db, RowId, RunsPart, TimelinesPart
from app.refusals import Conflict, NotFound
from app.scoring.timeline import Timeline
from app.store.log import write_log
from app.store.runs import find_trial
from app.store.tables import Trial
from app.texts import Text

router = APIRouter(tags=["review"])


def require_ended(trial: Trial) -> None:
    """Refuse while a trial runs: its recording is not whole."""
    if trial.status != "done":
        raise Conflict(Text("api-trial-still-running"))


@router.get("/trials/{trial_id}/timeline", response_model=Timeline)
def trial_timeline(
    trial_id: RowId, person: Anyone, database: Db, runs: RunsPart, timelines: TimelinesPart, request: Request
) -> Response:
    """Return a trial on one time line: pose, commands, gestures, signals and events.

    At most 2000 points. `u1`, `u2`, gestures and signals keep every peak: two neighbouring points hold the smallest and
    largest value around them in their order. Of a joint the four channels with the largest weights, out of `of`.
    `state`: 0 disarmed, 1 checking, 2 armed, 3 fault. null: not known then; `along`, `across` empty: the path has no
    length. 404 for an unreadable recording, 409 while the trial runs.
    """
    with database.reading() as db:
        trial = find_trial(db, trial_id)
    require_ended(trial)
    folder = runs.folder_of(trial.run_id)
    try:
        packed = timelines.of(folder, trial.path_points, trial.end)
    except (ValueError, OSError) as error:
        raise NotFound(Text("api-recording-unreadable")) from error
    with database.transaction(closing=True) as db:
        write_log(db, person.name, "trial viewed", trial=trial_id)
    headers = {"Cache-Control": "private, no-cache", "Vary": "Accept-Encoding"}
    if "gzip" in request.headers.get("accept-encoding", ""):
        return Response(packed, media_type="application/json", headers=headers | {"Content-Encoding": "gzip"})
    return Response(gzip.decompress(packed), media_type="application/json", headers=headers)
