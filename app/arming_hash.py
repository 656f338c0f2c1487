"""The hash that names what drives a chair: its parameter set, and its chair document where it has one."""

from hashlib import sha256


def arming_hash(parameters_hash: str, chair_document: str) -> str:
    """Return the hash with which a chair is armed, 64 hexadecimal digits.

    Without a chair document it is that of the parameter set: what was practised on the virtual chair is compared by it.

    Parameters
    ----------
    parameters_hash : str
        SHA-256 of the parameter set, 64 hexadecimal digits.
    chair_document : str
        The hexadecimal digits of the chair document as the chair tells them; empty: it has none.
    """
    if not chair_document:
        return parameters_hash
    return sha256(bytes.fromhex(parameters_hash) + bytes.fromhex(chair_document)).hexdigest()
