"""Generating: real jumps, continued, repaired, in parts, stopped; always the same dataset."""

from pathlib import Path

import numpy as np
import pytest
from small_datasets import BACKEND, WIDE_STICK, generated, small

from snapjump.batch import simulate_designs
from snapjump.checks import ParameterError
from snapjump.dataset.folder import DatasetFolder
from snapjump.dataset.generate import GenerationError
from snapjump.dataset.read import load_dataset
from snapjump.dataset.simulate import curve_over
from snapjump.dataset.statistics import gather
from snapjump.dataset.work import job_of, make_shard
from snapjump.executor.local import LocalExecutor
from snapjump.files.sealed import read_sealed

SPECIFICATION = small()


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory) -> Path:
    """A dataset that nobody disturbed."""
    path = tmp_path_factory.mktemp("whole")
    generated(path, SPECIFICATION)
    return path


def same(path: Path, whole: Path) -> bool:
    return (path / "manifest.json").read_bytes() == (whole / "manifest.json").read_bytes()


def test_rows_are_those_of_the_batch_of_designs(undisturbed):
    frame = load_dataset(undisturbed).frame()
    designs = SPECIFICATION.plan.designs(0, 24)
    assert (frame[[axis.column for axis in SPECIFICATION.axes]].to_numpy() == designs).all()
    assert frame["index"].tolist() == list(range(24))
    base, axes = SPECIFICATION.simulation, SPECIFICATION.axes
    batch = simulate_designs(base, designs, curve=curve_over(base, axes), threads=1)
    for name, values in batch.columns().items():
        if name != "kernel_seconds":
            np.testing.assert_array_equal(frame[name].to_numpy(), values, err_msg=name)
    jumped = frame["status"] == "ok"
    assert jumped.sum() >= 20
    assert (frame["y_bar"][jumped] > 0.0).all()
    assert (frame["steps"] > 50).all() and (frame["newton_iterations"] > frame["steps"]).all()
    assert (frame["kernel_seconds"] > 0.0).all()
    assert (frame["mount_height_bar"].between(0.04, 0.1)).all()
    # Nothing is missing without a status that tells why; derivatives have a flag of their own.
    own = {name for name in frame if "_d_" in name} | {"differentiable", "graze_distance"}
    assert not frame[jumped].drop(columns=[*own]).isna().to_numpy().any()


@pytest.mark.compiles
def test_derivatives_of_every_apex(tmp_path, undisturbed):
    asked = small(6, 3, friction=WIDE_STICK, sensitivities=True)
    generated(tmp_path / "asked", asked)
    frame = load_dataset(tmp_path / "asked").frame()
    columns = [name for name in frame if name.startswith("d") and "_d_" in name]
    assert len(columns) == 8
    jumped = frame["status"] == "ok"
    assert jumped.sum() >= 4
    assert np.isfinite(frame.loc[jumped, columns].to_numpy(dtype=float)).all()
    assert frame.loc[jumped, "dy_bar_d_epsilon"].median() > 0.0
    assert (frame["graze_distance"] > 0.0).all()
    flags = frame["differentiable"].astype(bool)
    assert (flags == (jumped & (frame["graze_distance"] > 1e-5))).all()
    # Nobody asked for them in the other one.
    assert load_dataset(undisturbed).frame()[columns].isna().to_numpy().all()


@pytest.mark.compiles
def test_outputs_that_are_asked_for_are_columns(tmp_path, undisturbed):
    asked = small(outputs=["clamp_work_J", "max_strain"])
    generated(tmp_path, asked)
    dataset, plain = load_dataset(tmp_path), load_dataset(undisturbed)
    frame, others = dataset.frame(), plain.frame()
    assert dataset.specification["outputs"] == ["max_strain", "clamp_work_J"]
    assert {*frame} - {*others} == {"max_strain", "clamp_work_J"}
    jumps = [name for name in others if name != "kernel_seconds"]
    assert frame[jumps].equals(others[jumps]) and dataset.sha256 != plain.sha256
    designs, curve = asked.plan.designs(0, 24), curve_over(asked.simulation, asked.axes)
    batch = simulate_designs(asked.simulation, designs, curve=curve, lanes=1, outputs=asked.outputs)
    for name in asked.outputs:
        np.testing.assert_array_equal(frame[name].to_numpy(), getattr(batch, name))


def test_any_inputs_are_axes(tmp_path):
    """Inputs that change the beam or its scales, or are words otherwise, are axes as well."""
    ranges = {
        "robot.thickness_m": None,
        "robot.mount_height": [2e-3, 3e-3],
        "contact.stiffness_N_m": [5e3, 2e4],
        "damping.relaxation_time_s": [1e-6, 1e-5],
    }
    plan = {"name": "latin_hypercube", "count": 8, "inputs": ranges}
    design, environment = {"epsilon": 0.25}, {"mass_bar": 1.0}
    given = {"plan": plan, "friction": WIDE_STICK, "design": design, "environment": environment}
    asked = small(shard_size=4, sensitivities=True, **given)
    assert asked.simulation.design.epsilon == 0.25
    assert small(shard_size=4, sensitivities=True, **given, robot={"thickness_m": 6e-5}) == asked
    generated(tmp_path, asked)
    dataset = load_dataset(tmp_path)
    assert dataset.axes == asked.axes and [axis.path for axis in asked.axes] == list(ranges)
    frame = dataset.frame()
    columns = ["thickness_m", "mount_height", "stiffness_N_m", "relaxation_time_s"]
    assert list(frame.columns)[:6] == ["index", *columns, "x_bar"]
    assert (frame[columns].to_numpy() == asked.plan.designs(0, 8)).all()
    np.testing.assert_allclose(frame["mount_height_bar"], frame["mount_height"] / 0.02, rtol=1e-12)
    jumped = frame["status"] == "ok"
    slopes = [f"dy_bar_d_{name}" for name in columns]
    assert jumped.sum() >= 6 and np.isfinite(frame.loc[jumped, slopes].to_numpy(float)).all()
    assert gather(dataset).edges.shape[0] == 4


def test_no_more_than_four_with_derivatives():
    ranges = {f"robot.{name}": None for name in ("length_m", "width_m", "thickness_m")}
    ranges |= {"design.epsilon": None, "environment.mu": None}
    plan = {"name": "sobol", "count": 8, "inputs": ranges}
    assert len(small(plan=plan, friction=WIDE_STICK).axes) == 5
    with pytest.raises(ParameterError, match=r"plan\.inputs = .* at most 4"):
        small(plan=plan, friction=WIDE_STICK, sensitivities=True)


def test_designs_that_cannot_be_are_rows_with_a_status(tmp_path):
    """A beam of a fortieth of its length is compressed straight before it buckles and snaps."""
    plan = {"name": "sobol", "count": 16, "epsilon": [0.005, 0.05]}
    thick = {"thickness_m": 5e-4, "youngs_modulus_Pa": 2e8, "density_kg_m3": 500.0}
    specification = small(16, plan=plan, robot=thick)
    assert generated(tmp_path, specification).manifest["statuses"] == {"no_threshold": 3, "ok": 13}
    frame = load_dataset(tmp_path).frame()
    refused = frame["status"] == "no_threshold"
    assert frame.loc[refused, "epsilon"].max() < frame.loc[~refused, "epsilon"].min()
    for name in ("mount_height_bar", "x_bar", "y_bar", "liftoff_time_s"):
        assert (frame[name].isna() == refused).all()
    # An error is not known either where the mismatch is large for so small a pre-compression.
    unknown = 0.5 * frame["delta_alpha_rad"].abs() > 0.6 * frame["epsilon"] ** 0.5
    assert (frame["x_error_estimate_percent"].isna() == (refused | unknown)).all()
    assert unknown.any() and not (refused | unknown).all()
    assert not frame.loc[refused, "within_tier"].any()


def test_shards_of_any_size_hold_the_same_rows(undisturbed, tmp_path):
    generated(tmp_path, small(shard_size=24))
    one, several = (load_dataset(path).frame() for path in (tmp_path, undisturbed))
    times = ["kernel_seconds"]
    assert one.drop(columns=times).equals(several.drop(columns=times))


def test_what_is_there_is_kept_and_what_is_missing_made(undisturbed, tmp_path):
    told: list[str] = []
    first = generated(tmp_path, SPECIFICATION, progress=lambda done, text: told.append(text))
    assert (first.made, first.kept, first.damaged) == (24, 0, [])
    assert told[0] == "0 of 24 jumps" and told[-1].startswith("24 of 24 jumps, ")
    assert "/s, " in told[-1] and told[-1].endswith(" left")
    before = {file: file.stat().st_mtime_ns for file in tmp_path.glob("shards/*")}
    (tmp_path / "shards" / "_shard-00001.json").unlink()
    second = generated(tmp_path, SPECIFICATION)
    assert (second.made, second.kept, second.damaged) == (8, 16, [])
    after = {file: file.stat().st_mtime_ns for file in tmp_path.glob("shards/*")}
    changed = {file.stem for file in after if after[file] != before[file]}
    assert changed == {"shard-00001", "_shard-00001"} and same(tmp_path, undisturbed)


def test_damage_is_named_and_repaired(undisturbed, tmp_path):
    generated(tmp_path, SPECIFICATION)
    shard = tmp_path / "shards" / "shard-00002.parquet"
    content = bytearray(shard.read_bytes())
    content[len(content) // 2] ^= 1
    shard.write_bytes(content)
    (tmp_path / "manifest.json").write_text("{")
    again = generated(tmp_path, SPECIFICATION)
    assert again.damaged == ["shard-00002.parquet is not what was written"]
    assert again.made == 8 and same(tmp_path, undisturbed)


def test_parts_make_the_whole(undisturbed, tmp_path):
    first = generated(tmp_path, SPECIFICATION, part=2, parts=2)
    assert first.made == 8 and not first.manifest["complete"]
    assert first.manifest["dataset_sha256"] is None
    with pytest.raises(ParameterError, match="8 of 24 rows"):
        load_dataset(tmp_path)
    second = generated(tmp_path, SPECIFICATION, part=1, parts=2)
    assert second.made == 16 and same(tmp_path, undisturbed)


def test_what_stops_it_leaves_what_is_done_listed(undisturbed, tmp_path):
    def stop(done: float, text: str) -> None:
        if (tmp_path / "shards" / "_shard-00001.json").exists():
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        generated(tmp_path, SPECIFICATION, progress=stop)
    manifest = read_sealed(tmp_path / "manifest.json")
    assert manifest is not None and manifest["rows"] == 16 and not manifest["complete"]
    assert generated(tmp_path, SPECIFICATION).made == 8 and same(tmp_path, undisturbed)


def test_a_shard_that_another_spoils_is_made_again(undisturbed, tmp_path):
    """A worker that was given up too early may write all the same."""

    class Spoiling(LocalExecutor):
        rounds = 0

        def answers(self, work, jobs, progress):
            self.rounds += 1
            for answer in super().answers(work, jobs, progress):
                if self.rounds <= self.spoilt and answer["shard"] == 1:
                    (tmp_path / "shards" / "shard-00001.parquet").write_bytes(b"other")
                yield answer

    executor = Spoiling()
    executor.spoilt = 1
    assert generated(tmp_path, SPECIFICATION, executor).made == 24 + 8
    assert same(tmp_path, undisturbed)
    (tmp_path / "shards" / "_shard-00001.json").unlink()
    executor.rounds, executor.spoilt = 0, 10
    with pytest.raises(GenerationError, match=r"\[1\]"):
        generated(tmp_path, SPECIFICATION, executor)


def test_a_worker_with_other_sources_refuses(tmp_path):
    folder = DatasetFolder(tmp_path)
    folder.open(SPECIFICATION)
    job = job_of(folder, SPECIFICATION, BACKEND, 0)
    job["specification"] = {**job["specification"], "source_sha256": "of another version"}
    with pytest.raises(ParameterError, match="source_sha256"):
        make_shard(job, None)
    assert not list(tmp_path.glob("shards/*"))
