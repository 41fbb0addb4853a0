"""Where configurations and studies lie: within an installed package, beside it in a clone.

A clone has ``conf`` and ``experiments`` at its top; a wheel has them as ``snapjump/conf`` and
``snapjump/experiments``, so that nothing of such a name lies on a user's path.
"""

from snapjump.files.sources import PACKAGE

INSTALLED = (PACKAGE / "conf").is_dir()
_TOP = PACKAGE if INSTALLED else PACKAGE.parent
CONF = _TOP / "conf"
EXPERIMENTS = _TOP / "experiments"
# What a user types.
PROGRAM = "snapjump" if INSTALLED else "python run.py"


STUDIES = "experiments."  # how their modules are named in a clone


def importable(module: str) -> str:
    """The name that a module is imported by."""
    return f"snapjump.{module}" if INSTALLED and module.startswith(STUDIES) else module


def in_a_clone(module: str) -> str:
    """The name that it has in a clone, which what is kept is known by."""
    bare = module.removeprefix("snapjump.")
    return bare if bare.startswith(STUDIES) else module
