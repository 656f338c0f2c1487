"""Stands in for pylsl in a process of tests: one stream is on the network at once, and it does not answer."""

cf_double64, cf_string = 2, 3


class StreamInfo:
    """What the stream says of itself."""

    def name(self):
        return "amplifier"

    def type(self):
        return "EEG"

    def source_id(self):
        return "amplifier-1"

    def hostname(self):
        return "laboratory"

    def uid(self):
        return "1"

    def channel_count(self):
        return 4

    def channel_format(self):
        return cf_double64

    def nominal_srate(self):
        return 100.0


class StreamInlet:
    def __init__(self, *_arguments, **_keywords):
        raise RuntimeError("the stream does not answer")


def resolve_streams(wait_time):
    assert wait_time > 0.0
    return [StreamInfo()]


def local_clock():
    return 0.0


def set_config_content(_content):
    """Do nothing: there is no library of a device."""
