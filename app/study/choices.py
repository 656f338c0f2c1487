"""The choices of a study: the kind of simulated person, the map that drives, and whether it adapts."""

from typing import Literal

Mode = Literal["off", "suggest", "auto"]
PersonKind = Literal["steady", "improving", "deteriorating", "redonned"]
StudyMap = Literal["pca", "guided", "prior"]
FigureFormat = Literal["png", "svg"]
FigureChoice = Literal[FigureFormat, "none"]
