"""The hash with which a chair is armed."""

import hashlib

from hypothesis import given
from hypothesis import strategies as st

from app.arming_hash import arming_hash

digits = st.binary(min_size=32, max_size=32).map(bytes.hex)
documents = st.binary(min_size=8, max_size=8).map(bytes.hex)


@given(digits)
def test_without_a_document_it_is_that_of_the_set(parameters):
    assert arming_hash(parameters, "") == parameters


@given(digits, documents)
def test_with_a_document_it_is_of_both(parameters, document):
    both = hashlib.sha256(bytes.fromhex(parameters + document)).hexdigest()
    assert arming_hash(parameters, document) == both
