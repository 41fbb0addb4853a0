"""Snapjump from the command line: ``python run.py --help`` tells how."""

import sys

if __name__ == "__main__":
    try:
        from snapjump.__main__ import main

        sys.exit(main())
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        sys.exit(130)
