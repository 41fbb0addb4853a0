"""``dataset``: its folder, its files, and which of several jobs that share it this one is."""

from collections.abc import Sequence

from snapjump.checks import check_integer, check_text
from snapjump.declare.fields import Part, flag, integer


class DatasetOptions(Part):
    """``path``: the folder, None for one named after all that determines the dataset; ``outputs``:
    beside those of all jumps, the names of others, which cost time."""

    group = "dataset"

    path: str | None = None
    sensitivities: bool = flag(False)
    outputs: Sequence[str] = ()
    shard_size: int = integer(1024, least=1, most=1_000_000)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.path is not None:
            check_text("dataset.path", self.path, "null, or a folder")

    @property
    def contents(self) -> tuple[int, bool, Sequence[str]]:
        """Those that determine the files, as a specification takes them."""
        return self.shard_size, self.sensitivities, self.outputs


class SharedDataset(DatasetOptions):
    """One that ``parts`` jobs make together, of which this is number ``part``."""

    part: int = 1
    parts: int = integer(1, least=1, most=10_000)

    def __post_init__(self) -> None:
        super().__post_init__()
        check_integer("dataset.part", self.part, 1, self.parts)
