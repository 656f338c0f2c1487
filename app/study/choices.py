"""What can be chosen of a study: who the simulated person is, which map drives, whether it adapts."""

from typing import Literal

Mode = Literal["off", "suggest", "auto"]
PersonKind = Literal["steady", "improving", "deteriorating", "redonned"]
StudyMap = Literal["pca", "guided", "prior"]
FigureFormat = Literal["png", "svg"]
FigureChoice = Literal[FigureFormat, "none"]
