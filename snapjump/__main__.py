"""The command ``snapjump``, which is ``python -m snapjump`` and, in a clone, ``python run.py``."""

import sys

from snapjump.files.extras import MissingExtraError, extras_named


def main() -> int:
    """Do what ``sys.argv`` says; returns the exit code."""
    try:
        with extras_named():
            from snapjump.run.tasks.command_line import main as run

            return run()
    except MissingExtraError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
