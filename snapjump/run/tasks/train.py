"""``task=train``: a forward model from a dataset, its errors, and the file it is kept in."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from snapjump.checks import ParameterError
from snapjump.dataset.folder import DatasetFolder, default_path
from snapjump.dataset.options import DatasetOptions
from snapjump.dataset.read import load_dataset
from snapjump.dataset.specification import specify
from snapjump.declare.members import make_member
from snapjump.files.atomic import write_bytes
from snapjump.files.layout import PROGRAM
from snapjump.files.result_folder import ResultFolder, physics
from snapjump.files.sealed import file_sha256
from snapjump.learning.data import JumpData
from snapjump.learning.export import export
from snapjump.learning.forward_model import ForwardModel
from snapjump.learning.learn import FORWARD_MODEL, Learned, check_slopes, learn
from snapjump.learning.measures import errors
from snapjump.learning.timing import microseconds
from snapjump.learning.training import Training
from snapjump.plan.parts.axes import labels_of
from snapjump.run.tasks.base import INTERRUPTED, NOT_FINITE, OK, SIMULATION, Outcome, Progress, Task
from snapjump.run.tasks.complete import whole
from snapjump.run.tasks.names import given_overrides
from snapjump.show.plots.training import draw_training
from snapjump.show.terminal.block import number
from snapjump.surrogate.base import SurrogateOptions
from snapjump.tracking.base import DatasetUse, Model
from snapjump.tracking.parts.tracked import write_curves, write_datasets, write_model

ONNX, REGISTERED = "forward_model.onnx", "snapjump-forward-model"
ROWS = ("rows_train", "rows_validation", "rows_test")
# What the command that makes the dataset does not know.
OF_TRAINING = ("task", "surrogate", "training", "tracking", "figures")


class Train(Task):
    """Trains a surrogate on all of a dataset but the test set, which it is measured on."""

    keys = (*SIMULATION, "dataset", "plan", "surrogate", "training")

    def prepare(self, config: Mapping[str, Any]) -> None:
        self._config = config
        training = whole(Training, config.get("training"))
        self._options: SurrogateOptions = make_member("surrogate", config.get("surrogate"))
        path = dataset_path(config)
        if not path.is_dir():
            allowed = f"a folder with a dataset; make it with: {command_of_dataset()}"
            raise ParameterError("dataset.path", str(path), allowed)
        self._data = JumpData(load_dataset(path), training, config["seed"])
        check_slopes(self._options, self._data)

    def run(self, folder: ResultFolder, progress: Progress) -> Outcome:
        dataset = self._data.dataset
        path = dataset.folder.path
        use = DatasetUse(path.name, dataset.sha256, str(path), dataset.rows, "training")
        write_datasets(folder, [use])
        try:
            learned = learn(
                self._data, self._options, progress, physics(self._config), step=self.step
            )
        except FloatingPointError as error:
            return Outcome(NOT_FINITE, str(error))
        file = folder.path / FORWARD_MODEL
        write_bytes(file, learned.file.read_bytes())
        write_curves(folder, learned.curves)
        if self._config["figures"]:
            self._draw(folder, learned)
        model = ForwardModel(learned.network, learned.about)
        if model.network.differentiable and self._config["tracking"]["name"] != "off":
            progress(1.0, "writing ONNX")
            export(model, folder.path / ONNX, self._config["seed"])
            names = [axis.column for axis in model.axes]
            write_model(folder, Model(folder.path / ONNX, REGISTERED, names, ("x_bar", "y_bar")))
        design = self._data.test.designs[:1].double().numpy()
        inference_us = microseconds(lambda: model.predict(design))
        about = learned.about
        summary = {
            "checkpoint": os.path.relpath(file),
            **about["measures"],
            "train_seconds": about["train_seconds"],
            "trained_before": learned.kept,
            **{key: about[key] for key in ("epochs", "parameters", *ROWS)},
            "dataset_sha256": dataset.sha256,
            "inference_us": inference_us,
        }
        return Outcome(OK, "", summary)

    def report(self, outcome: Outcome) -> list[tuple[str, str]]:
        found, name = outcome.summary, self._config["surrogate"]["name"]
        lines = [("forward model", f"{name} on {self._data.dataset.folder.path.name}")]
        if outcome.status == INTERRUPTED:
            return [*lines, ("stopped", "the same command goes on")]
        if "mae_bar" not in found:
            return lines
        covered = found.get("coverage")
        intervals = f"{100.0 * covered:.1f} % of the apexes inside" if covered is not None else ""
        before = ", before this run" if found["trained_before"] else ""
        return [
            *lines,
            ("MAE", f"{number(found['mae_bar'])} L (x {number(found['mae_x_bar'])}, "
                    f"y {number(found['mae_y_bar'])}), 95 % below {number(found['p95_bar'])} L, "
                    f"on {found['rows_test']:,} jumps it has not seen"),
            ("intervals", intervals),
            ("trained", f"{number(found['train_seconds'])} s{before}, {found['epochs']} epochs, "
                        f"{found['rows_train']:,} jumps, {found['parameters']:,} parameters"),
            ("one design", f"{number(found['inference_us'])} us"),
            ("kept in", str(found["checkpoint"])),
        ]  # fmt: skip

    def reads(self, config: Mapping[str, Any]) -> dict[str, str]:
        return {"dataset.path": file_sha256(DatasetFolder(dataset_path(config)).manifest)}

    def _draw(self, folder: ResultFolder, learned: Learned) -> None:
        test = self._data.test
        off = errors(learned.network, test)
        title = (
            f"{self._config['surrogate']['name']}: MAE {learned.about['measures']['mae_bar']:.4f} L"
            f" on {len(off):,} jumps it has not seen, dataset {self._data.dataset.sha256[:8]}"
        )
        labels = labels_of(self._data.dataset.axes)
        designs, apexes = (part.double().numpy() for part in (test.designs, test.apexes))
        shown = (learned.curves, labels, designs, apexes, off, title)
        folder.write_figures(lambda path: draw_training(*shown, path / "training.png"))


def dataset_path(config: Mapping[str, Any]) -> Path:
    """The folder that is given, or that of the dataset this configuration would make.
    Raises ParameterError."""
    given: DatasetOptions = whole(DatasetOptions, config.get("dataset"))
    if given.path is not None:
        return Path(given.path)
    return default_path(specify(config, *given.contents))


def command_of_dataset() -> str:
    """The command that makes the dataset of this configuration."""
    given = given_overrides()
    kept = [
        text for text in given if text.lstrip("+").split("=")[0].split(".")[0] not in OF_TRAINING
    ]
    return " ".join([f"{PROGRAM} task=dataset", *kept])
