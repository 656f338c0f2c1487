"""The units of measures, each as it is written on pages and in reports, and its code.

The codes are those of UCUM, the Unified Code for Units of Measure, which FHIR uses.
"""

from typing import Final

UCUM: Final = "http://unitsofmeasure.org"  # the system of these codes in FHIR

NUMBER: Final = ("", "1")  # counts and ratios
SHARE: Final = ("%", "1")  # stored as a share of 1
METRES: Final = ("m", "m")
SQUARE_METRES: Final = ("m²", "m2")
PER_METRE: Final = ("/m", "/m")
DEGREES: Final = ("°", "deg")
SECONDS: Final = ("s", "s")
METRES_PER_SECOND: Final = ("m/s", "m/s")
PER_MINUTE: Final = ("", "/min")
BITS_PER_SECOND: Final = ("bit/s", "bit/s")
