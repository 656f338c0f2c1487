"""Why a chair is not armed, beyond what the gate itself watches."""

from app.faults import EXPLANATIONS, State
from app.pipeline.brakes import missing_brake
from app.pipeline.loop import ControlLoop


def refusal(loop: ControlLoop, digest: str) -> str:
    """Return why the parameters of this hash cannot be armed now, in a sentence; empty when they can."""
    setup, gate = loop.setup, loop.setup.chain.gate
    if setup.chain.parameters is None:
        return "There is nothing to drive with: calibrate first."
    if digest != setup.hash:
        return "The controls were changed meanwhile: load them again, then arm."
    missing = missing_brake(setup.chain.parameters)
    if missing:
        return missing
    if gate.state is State.FAULT:
        what = EXPLANATIONS[gate.fault]
        return f"{what.happened} {what.next_step}"
    return real_chair_refusal(loop)


def real_chair_refusal(loop: ControlLoop) -> str:
    """Return what else a real chair needs before it is armed, in a sentence; empty for the virtual one."""
    setup = loop.setup
    chair, parameters = setup.chair, setup.parameters
    if not chair.is_real or parameters is None:
        return ""
    if setup.mistrust:
        return setup.mistrust
    if loop.run is None:
        return "A real chair drives only while it is recorded: begin a drive first."
    if chair.silent:
        return chair.words()
    if chair.inhibited:
        return f"{chair.words()} Look around, release the switch, then arm again."
    if "acceleration" in (parameters.mode_u1, parameters.mode_u2) and not chair.switch_seen:
        return (
            "In acceleration mode a chair cruises by itself, so a real one needs its stop switch: press and release "
            "it once to show that it works, or choose velocity mode."
        )
    return ""
