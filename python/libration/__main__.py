"""The command `libration`: ``python -m libration period 60deg``."""

import signal
import sys

from . import _native


def main() -> int:
    """Runs the command line; returns the exit status."""
    # Python's own handler would only be heard when the command has ended.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _native.program(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
