"""What a test of a feature has: the clinics of tests/api, with a trial, and people who read of it elsewhere."""

from api.conftest import (  # noqa: F401
    _quick,
    calibrated,
    calibrated_state,
    clinic,
    consented,
    in_session,
    make_state,
    new_state,
    settings,
    signed_in,
    start_from,
    trial,
)
