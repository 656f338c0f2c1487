"""Numbers as people read them in a sentence."""

MINUS = "\u2212"


def percent(share: float, digits: int = 0) -> str:
    """Return a share in percent with `digits` decimals and a space before the sign, as in the SI."""
    return with_minus(f"{100.0 * share:.{digits}f} %")


def signed_percent(share: float) -> str:
    """Return a share in whole percent with its sign, also when it is positive."""
    return with_minus(f"{100.0 * share:+.0f} %")


def with_minus(figure: str) -> str:
    """Return a figure with the sign for minus in place of a hyphen."""
    return figure.replace("-", MINUS)
