"""Ctrl-C, at a time of one's choosing."""

import signal

import pytest

import libration as lb


def interrupted_after(seconds, call):
    """What a call raises that is interrupted so soon."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        with pytest.raises(lb.Interrupted) as caught:
            call()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    return caught.value
