from app.hardware.shirt.senders import MOST, Senders, address_text

SHIRT, FORGER = ("10.0.0.2", 4000), ("10.0.0.3", 4000)


def test_the_first_sender_is_the_shirt_however_long_it_is_silent():
    senders = Senders()
    assert senders.name == senders.other == ""
    assert senders.takes(SHIRT, 0, silent=True)
    assert not senders.takes(FORGER, 0, silent=True)
    assert not senders.takes((SHIRT[0], 4001), 0, silent=True)
    assert senders.takes(SHIRT, 0, silent=True)
    assert (senders.name, senders.others) == ("10.0.0.2:4000", 2)


def test_another_sender_is_named_and_a_person_may_take_it():
    senders = Senders()
    senders.takes(SHIRT, 0, silent=False)
    for _ in range(3):
        senders.takes(FORGER, 0, silent=False)
    assert senders.other == "10.0.0.3:4000"
    assert not senders.use("10.0.0.9:4000")
    assert senders.takes(SHIRT, 0, silent=False)
    assert senders.use("10.0.0.3:4000")
    assert (senders.name, senders.other, senders.others) == ("10.0.0.3:4000", "", 0)
    assert not senders.takes(SHIRT, 0, silent=False)


def test_a_device_that_was_started_again_may_come_from_elsewhere_only_after_silence():
    senders = Senders()
    assert senders.takes(SHIRT, 7, silent=True)
    assert not senders.takes(FORGER, 8, silent=False)
    assert not senders.takes(FORGER, 7, silent=True)
    assert senders.takes(FORGER, 8, silent=True)
    assert not senders.takes(SHIRT, 7, silent=True)


def test_a_thousand_senders_fill_no_memory():
    senders = Senders()
    senders.takes(SHIRT, 0, silent=False)
    for port in range(1, 1001):
        senders.takes(("10.0.0.9", port), 0, silent=False)
    assert senders.others == 1000
    assert len(senders._frames) == MOST


def test_addresses_are_written_as_people_write_them():
    assert address_text(("::1", 5252, 0, 0)) == "[::1]:5252"
