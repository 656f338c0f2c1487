"""How demanding a test felt: the NASA task load index without weights ("raw TLX")."""

from app.quantities import Document, Points


class Workload(Document):
    """The six answers of the NASA task load index, each 0 (low) to 100 (high), or left out."""

    mental: Points | None = None
    physical: Points | None = None
    temporal: Points | None = None
    performance: Points | None = None  # 0: perfect, 100: failure
    effort: Points | None = None
    frustration: Points | None = None

    @property
    def answers(self) -> list[int]:
        """The answers that were given."""
        return [value for value in self.model_dump().values() if value is not None]

    @property
    def raw_tlx(self) -> float | None:
        """The mean of the six answers; None when one was left out, because the others do not stand for it."""
        answers = self.answers
        return sum(answers) / len(answers) if len(answers) == len(Workload.model_fields) else None
