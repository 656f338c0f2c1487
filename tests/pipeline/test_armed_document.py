"""A real chair is armed with its document, and drives with no other."""

from app.calibration.vocabulary import arming_hash


def test_a_chair_is_armed_with_its_document_and_goes_on_with_no_other(control, chair, tmp_path):
    control.live(0.1)
    control.done("chair", config=chair.document)
    control.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive", cues=[], meta={})

    def hear(**changes):
        control.live(0.01)
        chair.commands()
        chair.say(**changes)
        control.live(0.01)

    for changes in ({}, {"stop_input": 1, "state": 3}, {}):
        hear(document=b"measured", **changes)
    digits = b"measured".hex()
    told = control.done("status")["chair"]
    assert (told["document"], told["crawls"]) == (digits, False)
    assert "changed meanwhile" in control.refused("arm", hash=control.parameters.hash)
    control.done("arm", hash=arming_hash(control.parameters.hash, digits))
    control.done("stop", by="tablet")
    hear(document=b"another!")
    assert "changed meanwhile" in control.refused("clear", stops=1)
    control.setup.close()
