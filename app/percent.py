"""A share in percent, as people read it."""


def percent(share: float, digits: int = 0) -> str:
    """Return a share in percent with so many decimals, with a space before the sign as the SI has it."""
    return f"{100.0 * share:.{digits}f} %"


def signed_percent(share: float) -> str:
    """Return a share in whole percent with its sign, also when it is positive."""
    return f"{100.0 * share:+.0f} %"
