"""Ctrl-C, at a time of one's choosing."""

import signal

import pytest

import libration as lb


def alarmed(seconds, call):
    """The result of a call during which a signal equivalent to Ctrl-C arrives."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        return call()
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def interrupted_after(seconds, call):
    """The exception of a call that is interrupted so soon."""
    with pytest.raises(lb.Interrupted) as caught:
        alarmed(seconds, call)
    return caught.value
