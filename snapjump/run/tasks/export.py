"""``task=export``: a forward model as ONNX, for programs that have no torch."""

from collections.abc import Mapping
from typing import Any

from snapjump.files.result_folder import ResultFolder
from snapjump.files.sealed import file_sha256
from snapjump.learning.export import check_exportable, export
from snapjump.learning.forward_model import forward_model
from snapjump.run.tasks.base import OK, Outcome, Progress, Task
from snapjump.show.terminal.block import number
from snapjump.targets.request import checkpoint_path

FILE = "forward_model.onnx"


class Export(Task):
    """Reads a checkpoint, writes ONNX, and compares the two."""

    keys = ("checkpoint",)

    def prepare(self, config: Mapping[str, Any]) -> None:
        self._path = str(checkpoint_path(config.get("checkpoint")))
        self._seed: int = config["seed"]
        self._model = forward_model(self._path)
        check_exportable(self._model, self._path)

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        progress(0.0, "exporting")
        found = export(self._model, folder.path / FILE, self._seed)
        return Outcome(OK, "", {"checkpoint": self._path, "onnx": FILE, **found._asdict()})

    def reads(self, config: Mapping[str, Any]) -> dict[str, str]:
        return {"checkpoint": file_sha256(checkpoint_path(config.get("checkpoint")))}

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
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
