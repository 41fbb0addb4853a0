"""Outputs of batches that cost time, and are there if they are asked for: what beams, clamps and
ground have borne, over all steps."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

import numpy as np

from snapjump.arrays import Array
from snapjump.backend.cuda import CudaBackend
from snapjump.batch.outcome import Batch
from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.outputs import Output
from snapjump.engine import outcome as c
from snapjump.engine.recorder import clamps, elastic, ground, momentum, strain
from snapjump.scenes.beam_loads import Bending, Clamping
from snapjump.scenes.bending import strain_per_turning
from snapjump.scenes.ground_impulse import momentum_gained
from snapjump.scenes.jump_loads import JumpLoads, Release, mass_kg
from snapjump.scenes.jump_outputs import RecordedJump


@dataclass(frozen=True, repr=False)
class LoadedBatch(Batch, JumpLoads):
    """A batch with outputs beside those of all batches. ``asked``: their names; ``loads``: by what
    was recorded the figures (R, K)."""

    asked: tuple[str, ...] = ()
    loads: Mapping[str, Array] = field(default_factory=dict)

    def reported(self) -> list[Output[Any]]:
        """Those of all batches, and those that were asked for."""
        return [one for one in self.declared() if not one.reads or one.name in self.asked]

    def figures(self, read: str) -> Array:
        """What was recorded (K, R). Raises ParameterError if nothing was."""
        if read not in self.loads:
            names = [one.name for one in OFFERED if read in one.reads]
            raise ParameterError("outputs", list(self.asked), f"some of {', '.join(names)} as well")
        return self.loads[read].T

    @property
    def bending(self) -> Bending:
        figures = self.figures("bending")
        begun = self.model.clamp.time_turned()
        return Bending(
            self.of_each(strain_per_turning) * figures[strain.TURNING],
            figures[strain.NODE] / self.simulation.discretization.elements,
            (figures[strain.WHEN] + begun) * self.scales.time_s,
        )

    @property
    def clamping(self) -> Clamping:
        figures, unit_J = self.figures("clamping"), self.scales.energy_J
        return Clamping(
            figures[clamps.TORQUE] * unit_J,
            figures[clamps.WORK] * unit_J,
            figures[clamps.POWER] * unit_J / self.scales.time_s,
        )

    @property
    def push(self) -> Array:
        force = self.figures("push")[ground.FORCE] * self.scales.force_N
        return np.full_like(force, np.nan) if self.model.contact.is_constraint() else force

    @property
    def impulse(self) -> Array:
        figures, ended = self.figures("impulse"), self.outcome.T
        gained = momentum_gained(
            self.model,
            ended[c.TIME],
            ended[c.COM_Y] - figures[momentum.HEIGHT],
            ended[c.COM_VY] - figures[momentum.RISE],
        )
        unit_m_s: Any = self.scales.velocity_m_s
        return (gained - figures[momentum.AIR]) * unit_m_s * self.of_each(mass_kg)

    @property
    def release(self) -> Release:
        figures = self.figures("release")
        released = figures[elastic.START] - figures[elastic.LAST]
        return Release(
            figures[elastic.HEIGHT] * self.scales.length_m, released * self.scales.energy_J
        )


OFFERED = [one for one in LoadedBatch.declared() if one.reads]


def check_outputs(
    base: Simulation, outputs: Any, sensitivities: bool = False, key: str = "outputs"
) -> tuple[str, ...]:
    """Names of outputs that are asked for, in the order in which they are declared.
    Raises ParameterError for what batches do not offer, or not with this simulation."""
    offered = [one.name for one in OFFERED]
    every, recorded = ([one.name for one in kind.declared()] for kind in (Batch, RecordedJump))
    if isinstance(outputs, str) or not isinstance(outputs, Sequence):
        raise ParameterError(key, outputs, f"a list of some of {', '.join(offered)}")
    for name in outputs:
        if name in every:
            allowed = f"no {name}, which every batch has: some of {', '.join(offered)}"
            raise ParameterError(key, name, allowed)
        if name in recorded and name not in offered:
            why = f"{name} is read off one robot's trajectory or modes (task=simulate)"
            raise ParameterError(key, name, f"{why}; batches have {', '.join(offered)}")
        if name not in offered:
            raise ParameterError(key, name, f"some of {', '.join(offered)}")
        if list(outputs).count(name) > 1:
            raise ParameterError(key, list(outputs), "each once")
    if outputs and sensitivities:
        raise ParameterError(
            key, list(outputs), "none with sensitivities, whose march records those"
        )
    if outputs and isinstance(base.backend, CudaBackend):
        allowed = "scalar or lanes with outputs that are recorded: a card has outcomes only"
        raise ParameterError("backend", base.backend.name, allowed)
    return tuple(name for name in offered if name in outputs)


def reads_of(outputs: Sequence[str]) -> list[str]:
    """What must be recorded for outputs, each once."""
    return list(dict.fromkeys(read for one in OFFERED if one.name in outputs for read in one.reads))


def with_loads(batch: Batch, outputs: tuple[str, ...], loads: Mapping[str, Array]) -> Batch:
    """The batch with the outputs that were asked for, if any; ``loads``: figures (M, K) of the
    robots that were marched."""
    if not outputs:
        return batch
    spread = {read: batch.ready.spread(figures) for read, figures in loads.items()}
    kept = {declared.name: getattr(batch, declared.name) for declared in fields(batch)}
    return LoadedBatch(**kept, asked=outputs, loads=spread)
