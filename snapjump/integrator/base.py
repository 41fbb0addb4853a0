"""Time integrators: the contract that every one fulfils.

A scheme is a ``NamedTuple`` of numbers. A step has implicit stages 1 ... S, and every stage of
every scheme is the same problem (:mod:`snapjump.engine.assemble`),

    M A + grad V(q) + damping(q, v) + contact = 0,   v = (q - origin) rate_factor,
                                                     A = (v - drift) inertia_rate,

in which only two rates and the vectors ``origin`` and ``drift`` differ. Velocities and
accelerations are kept in slots: slot 0 is the beginning of the step, slots 1 ... S its stages (the
last one becomes slot 0 of the next step), and a scheme may keep a slot of history.
An explicit scheme has one stage, whose position is known and whose forces are only evaluated.
"""

from typing import Any, NamedTuple

from snapjump.number.methods import Contract, required


class Rates(NamedTuple):
    """dv/dq and dA/dv of a stage (1/T)."""

    rate_factor: Any
    inertia_rate: Any


class TimeIntegrator(Contract):
    """Time integrators: the contract that every one fulfils."""

    @required
    def slots(self) -> Any:
        """Velocities and accelerations to keep; a constant while compiling."""

    @required
    def stage_count(self) -> Any:
        """Stages S of a step; a constant while compiling."""

    @required
    def is_explicit(self) -> Any:
        """Whether the stage's position is known beforehand; a constant while compiling."""

    @required
    def ends_in_a_stage(self) -> Any:
        """Whether the last stage is the end of the step; a constant while compiling."""

    @required
    def stage_node(self, stage: Any) -> Any:
        """Time of a stage, as a share of the step."""

    @required
    def stage_rates(self, step: Any, ratio: Any) -> Any:
        """The :class:`Rates` of a step; ``ratio`` is its size over the last one's, first 0."""

    @required
    def weigh_slots(self, stage: Any, step: Any, ratio: Any, weights: Any) -> None:
        """Fill ``weights`` (slots) with what ``predict`` needs at every lane's own stage."""

    @required
    def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
        """Origin, drift and first guess of coordinate ``i`` of a stage."""

    @required
    def store_stage(
        self, work: Any, stage: Any, step: Any, ratio: Any, rates: Any, mask: Any
    ) -> Any:
        """Keep velocity and acceleration of the stage that has just converged.

        An explicit scheme finds the stage's acceleration in ``work.change``.

        Returns the step's estimated error in position (L, root mean square over the coordinates)
        for lanes whose last stage it was.
        """

    @required
    def end_step(self, work: Any, step: Any, mask: Any) -> None:
        """Move state and last slot from the last stage to the step's end, where they differ."""

    @required
    def keep_history(self, work: Any, step: Any, mask: Any) -> None:
        """Update the slot of history of lanes whose step stands, before the step is committed."""

    @required
    def error_power(self) -> Any:
        """Power of the step with which the estimated error shrinks."""

    @required
    def quadrature_weight(self, stage: Any) -> Any:
        """Weight of a stage (0: the beginning) in an integral over the step."""
