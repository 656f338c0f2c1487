"""Why a chair is not armed, apart from what the gate checks."""

from app.calibration.own_movement import own_movement_refusal
from app.faults import EXPLANATIONS, State
from app.pipeline.loop import ControlLoop
from app.pipeline.person_brakes import missing_brake


def refusal(loop: ControlLoop, digest: str) -> str:
    """Return in a sentence why the chair cannot be armed with the parameters of this hash; empty when it can."""
    setup, gate = loop.setup, loop.setup.chain.gate
    if loop.run is not None and loop.run.task is not None:
        return "The two-minute test is running, in which no chair moves: end it first, then arm."
    if setup.chain.parameters is None:
        return "There is nothing to drive with: calibrate first."
    if digest != setup.hash:
        return "The controls were changed meanwhile: load them again, then arm."
    missing = missing_brake(setup.chain.parameters)
    if missing:
        return missing
    if gate.state is State.FAULT:
        what = EXPLANATIONS[gate.fault]
        return f"{what.happened} {what.remedy} Take the stop back, then start again."
    return device_refusal(loop)


def device_refusal(loop: ControlLoop) -> str:
    """Return in a sentence which device is no longer paired, or what a real chair still needs before it is armed."""
    setup = loop.setup
    chair, parameters = setup.chair, setup.parameters
    lost = setup.network_shirt.lost_key() if setup.network_shirt else ""
    if lost:
        return f"The shirt is no longer paired: {lost}."
    lost = chair.lost_key()
    if lost:
        return f"The chair is no longer paired: {lost}."
    if not chair.is_real or parameters is None:
        return ""
    if setup.mistrust:
        return setup.mistrust
    unconfirmed = own_movement_refusal(parameters)
    if unconfirmed:
        return unconfirmed
    if loop.run is None:
        return "A real chair drives only while it is recorded: begin a drive first."
    if chair.silent:
        return chair.words()
    if chair.inhibited:
        return f"{chair.words()} Look around, release the switch, then arm again."
    if parameters.keeps_speed and not chair.switch_reported:
        return (
            "With “Keeps its speed” or “Keeps turning” a chair goes on by itself, so a real one needs its stop switch: "
            "press and release it once to show that it works, or choose “Follows the movement” on the Controls page."
        )
    return ""
