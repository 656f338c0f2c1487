"""Symbols and terms of publications that people do not read on screen (the glossary has a plain word for each)."""

import re

SYMBOLS = re.compile(
    r"""\b(?:E_diff|Dist|EVR|SPARC|LDLJ|PC1|PCA|AICc|rms|FS|FS/s|u1|u2)\b
    | \b(?:cross-talk|dead-zone|latched|cutoff|jerk|explains[ ]\S+[ ]?%|signal[ ]to[ ]noise|repeats[ ]within)\b
    | \b(?:guided|maps?)\b
    | rad/s | m/s³ | °/s³ | m/s3""",
    re.VERBOSE | re.IGNORECASE,
)
NAMES = re.compile(  # options and their values; what a floor plan is made of
    r"--[a-z-]+|pca\|guided\|prior\|best|pca\|guided|\[default: [a-z]+\]|\bROS map\b|\ba map's\b"
)


def symbols_in(text: str) -> list[str]:
    """Return the symbols that stand in a text for people."""
    return [found.group() for found in SYMBOLS.finditer(NAMES.sub("", text))]
