"""``tracking=off``: nothing is recorded, and nothing that could is imported."""

from snapjump.tracking.base import Tracker


class Off(Tracker):
    """No MLflow records."""
