"""``task=export``: a forward model as ONNX, for programs that have no torch."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from snapjump.files.result_folder import ResultFolder
from snapjump.tasks.base import OK, Outcome, Progress
from snapjump.terminal.block import number

if TYPE_CHECKING:
    from snapjump.learning.forward_model import ForwardModel

FILE = "forward_model.onnx"


class Export:
    """Reads a checkpoint, writes ONNX, and compares the two."""

    _path: str
    _seed: int
    _model: "ForwardModel"

    def prepare(self, config: Mapping[str, Any]) -> None:
        """Read the checkpoint, which checks it."""
        from snapjump.learning.export import check_exportable
        from snapjump.learning.forward_model import open_forward_model
        from snapjump.targets.request import checkpoint_path

        self._path = str(checkpoint_path(config.get("checkpoint")))
        self._seed = config["seed"]
        self._model = open_forward_model(self._path)
        check_exportable(self._model, self._path)

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        """Write the file, once it has been compared."""
        from snapjump.learning.export import export

        progress(0.0, "exporting")
        found = export(self._model, folder.path / FILE, self._seed)
        return Outcome(
            OK,
            "",
            {
                "checkpoint": self._path,
                "onnx": FILE,
                "max_difference": found.difference,
                "onnx_us": found.onnx_us,
                "torch_us": found.torch_us,
            },
        )

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        """The closing block."""
        lines = [("export", f"{self._model.about['surrogate']['name']} from {self._path}")]
        found = outcome.summary
        if "onnx" not in found:
            return lines
        return [
            *lines,
            ("difference", f"at most {found['max_difference']:.2g} standard deviations to torch"),
            ("one design", f"{number(found['onnx_us'])} us with onnxruntime, "
                           f"{number(found['torch_us'])} us with torch"),
        ]  # fmt: skip
