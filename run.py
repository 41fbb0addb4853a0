"""Snapjump from the command line: ``python run.py --help`` tells how."""

import sys
from pathlib import Path

if __name__ == "__main__":
    try:
        from snapjump.run.tasks.command_line import main

        sys.exit(main(Path(__file__).resolve().parent / "conf"))
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        sys.exit(130)
