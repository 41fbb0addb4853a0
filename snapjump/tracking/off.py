"""``tracking=off``: nothing is recorded, and nothing that could is imported."""

from snapjump.tracking.base import Record


class Off:
    """No records."""

    place = ""

    def check(self) -> None:
        """Nothing to check."""

    def record(self, record: Record, run_id: str | None = None) -> None:
        """No record, no id."""

    def open_parent(self, name: str, run_id: str | None) -> None:
        """No record, no id."""

    def close_parent(self, run_id: str, record: Record) -> None:
        """Nothing to complete."""
