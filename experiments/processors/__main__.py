"""The same bits on every processor: ``python -m experiments.processors``.

Computes hashes here and in child processes that take this processor for others, side by side, and
prints them as one JSON object; exit code 1 if any differ.
"""

import argparse
import json
import subprocess
import sys

from experiments.processors.hashes import HASHES
from experiments.processors.imitation import SETTINGS, check_imitation, environment


def main() -> int:
    """Compute or compare."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=list(SETTINGS), help="hashes of this process alone")
    asked = parser.parse_args().only
    if asked:
        check_imitation(asked)
        print(json.dumps({name: compute() for name, compute in HASHES.items()}))
        return 0
    command = [sys.executable, "-m", "experiments.processors", "--only"]
    children = {
        name: subprocess.Popen(
            [*command, name], env=environment(name), stdout=subprocess.PIPE, text=True
        )
        for name in SETTINGS
    }
    found = {"here": {name: compute() for name, compute in HASHES.items()}}
    for name, child in children.items():
        told, _ = child.communicate()
        if child.returncode != 0:
            return 1
        found[name] = json.loads(told)
    print(json.dumps(found, indent=2))
    return int(any(hashes != found["here"] for hashes in found.values()))


if __name__ == "__main__":
    sys.exit(main())
