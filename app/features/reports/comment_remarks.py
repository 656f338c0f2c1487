"""What was said about moments of trials, as remarks of a report."""

from collections.abc import Iterable
from typing import Final

from app.features.registration import TrialRemark
from app.features.reports.characters import without_invisible
from app.features.reports.document import Remark
from app.number_words import amount, with_minus

MOST_COMMENTS: Final = 100  # in one report: those of the newest trials


def comment_remarks(comments: Iterable[TrialRemark], sessions: dict[int, int], *, course: bool) -> tuple[Remark, ...]:
    """Return the comments on trials of the reported sessions, by their trials and moments.

    `sessions` are the numbers of the reported sessions by their ids. Each remark names who said it and when, the
    trial, and the moment on the trial's time line.
    """
    own = [one for one in comments if one.session_id in sessions]
    shown = own[-MOST_COMMENTS:]
    left_out = len(own) - len(shown)
    are_not = amount(left_out, "comment on earlier trials is", "comments on earlier trials are")
    first = (Remark("", f"{are_not} not shown."),) if left_out else ()
    return (*first, *(_remark(one, sessions[one.session_id] if course else None) for one in shown))


def _remark(comment: TrialRemark, session: int | None) -> Remark:
    where = "" if session is None else f"Session {session}, "
    revised = "" if comment.revised is None else f", revised {comment.revised.astimezone():%Y-%m-%d %H:%M}"
    said = f"{comment.person}, {comment.written.astimezone():%Y-%m-%d %H:%M}{revised}"
    moment = with_minus(f"{comment.t:.1f} s")
    head = f"{where}{comment.floorplan_title}, trial {comment.number}, at {moment}: {said}"
    return Remark(without_invisible(head), without_invisible(comment.text))
