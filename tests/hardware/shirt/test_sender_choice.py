from app.hardware.shirt.sender_choice import MOST, SenderChoice, address_text

SHIRT, FORGER = ("10.0.0.2", 4000), ("10.0.0.3", 4000)


def test_the_first_sender_is_the_shirt_however_long_it_is_silent():
    choice = SenderChoice()
    assert choice.name == choice.other == ""
    assert choice.accept(SHIRT, 0, silent=True)
    assert not choice.accept(FORGER, 0, silent=True)
    assert not choice.accept((SHIRT[0], 4001), 0, silent=True)
    assert choice.accept(SHIRT, 0, silent=True)
    assert (choice.name, choice.other_frames) == ("10.0.0.2:4000", 2)


def test_another_sender_is_named_and_a_person_may_take_it():
    choice = SenderChoice()
    choice.accept(SHIRT, 0, silent=False)
    for _ in range(3):
        choice.accept(FORGER, 0, silent=False)
    assert choice.other == "10.0.0.3:4000"
    assert not choice.use("10.0.0.9:4000")
    assert choice.accept(SHIRT, 0, silent=False)
    assert choice.use("10.0.0.3:4000")
    assert (choice.name, choice.other, choice.other_frames) == ("10.0.0.3:4000", "", 0)
    assert not choice.accept(SHIRT, 0, silent=False)


def test_a_device_that_was_started_again_may_come_from_elsewhere_only_after_silence():
    choice = SenderChoice()
    assert choice.accept(SHIRT, 7, silent=True)
    assert not choice.accept(FORGER, 8, silent=False)
    assert not choice.accept(FORGER, 7, silent=True)
    assert choice.accept(FORGER, 8, silent=True)
    assert not choice.accept(SHIRT, 7, silent=True)


def test_a_thousand_senders_fill_no_memory():
    choice = SenderChoice()
    choice.accept(SHIRT, 0, silent=False)
    for port in range(1, 1001):
        choice.accept(("10.0.0.9", port), 0, silent=False)
    assert choice.other_frames == 1000
    assert len(choice._frames) == MOST


def test_addresses_are_written_as_people_write_them():
    assert address_text(("::1", 5252, 0, 0)) == "[::1]:5252"
