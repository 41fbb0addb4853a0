"""Time integrators: the contract that every one fulfils.

A scheme is a ``NamedTuple`` of numbers. A step has implicit stages 1 ... S, and every stage of
every scheme is the same problem (:mod:`snapjump.engine.assemble`),

    M A + grad V(q) + damping(q, v) + contact = 0,   v = (q - q*) rate_factor,
                                                     A = (v - v*) inertia_rate,

in which only two rates and the predictors q* and v* of position and velocity differ. Velocities and
accelerations are kept in slots: slot 0 is the beginning of the step, slots 1 ... S its stages (the
last one becomes slot 0 of the next step), and a scheme may keep a slot of history.
An explicit scheme has one stage, whose position is known and whose forces are only evaluated.
"""

from typing import Any, ClassVar, NamedTuple

from snapjump.declare.fields import Part
from snapjump.number.methods import Contract, required


class Rates(NamedTuple):
    """dv/dq and dA/dv of a stage (1/T)."""

    rate_factor: Any
    inertia_rate: Any


class Reached(NamedTuple):
    """Velocity (L/T) and acceleration (L/T^2) of a coordinate at a stage."""

    velocity: Any
    acceleration: Any


class TimeIntegrator(Contract):
    """Time integrators: the contract that every one fulfils.

    Methods of a coordinate ``i`` find its numbers in the parts of ``work``
    (:mod:`snapjump.engine.work`).
    """

    @required
    def slots(self) -> Any:
        """Velocities and accelerations to keep; a constant while compiling."""

    def stage_count(self) -> Any:
        """Stages S of a step; a constant while compiling."""
        return 1

    def is_explicit(self) -> Any:
        """Whether the stage's position is known beforehand; a constant while compiling."""
        return False

    def ends_in_a_stage(self) -> Any:
        """Whether the last stage is the end of the step; a constant while compiling."""
        return True

    def abscissa(self, stage: Any) -> Any:
        """Time of a stage, as a share of the step."""
        return 1.0 + 0.0 * stage

    @required
    def stage_rates(self, step: Any, ratio: Any) -> Any:
        """The :class:`Rates` of a step; ``ratio`` is its size over the last one's, first 0."""

    @required
    def stage_coefficients(self, stage: Any, step: Any, ratio: Any, coefficients: Any) -> None:
        """Fill ``coefficients`` (slots) with what ``predict`` needs at the stage of every lane."""

    @required
    def predict(self, work: Any, i: Any, stage: Any, rates: Any) -> Any:
        """Predictors of position and velocity, and first guess, of coordinate ``i`` of a stage."""

    def reached(self, work: Any, i: Any, step: Any, rates: Any) -> Reached:
        """What coordinate ``i`` has :class:`Reached` at the stage whose position ``work.state``
        holds. An explicit scheme finds the stage's acceleration in its slot."""
        velocity = (work.state[i] - work.position_predictor[i]) * rates.rate_factor
        spin_up = (velocity - work.velocity_predictor[i]) * rates.inertia_rate
        return Reached(velocity, spin_up)

    @required
    def error(self, work: Any, i: Any, step: Any, ratio: Any, reached: Reached) -> Any:
        """Estimated error in position of coordinate ``i`` at the step's end, over ``error_scale``,
        given what its last stage has reached."""

    @required
    def error_scale(self, step: Any, ratio: Any) -> Any:
        """The unit (L) of ``error``."""

    def end_step(self, work: Any, step: Any, mask: Any) -> None:
        """Move state and last slot from the last stage to the step's end, where they differ."""
        pass

    def keep_history(self, work: Any, i: Any, step: Any, reached: Reached, mask: Any) -> None:
        """Update the slot of history of coordinate ``i`` in lanes whose step stands, before the
        step is committed."""
        pass

    @required
    def error_power(self) -> Any:
        """Power of the step with which the estimated error shrinks."""

    def quadrature_weight(self, stage: Any) -> Any:
        """Weight of a stage (0: the beginning) in an integral over the step."""
        return 0.5


class IntegratorOptions(Part):
    """An integrator and its numbers, and what tests measure of it.

    ``damping_at_infinity``: amplification of an infinitely fast oscillation, None if it grows.
    """

    group = "integrator"
    order: ClassVar[Any]
    stages: ClassVar[Any] = 1
    a_stable: ClassVar[bool] = True
    damping_at_infinity: ClassVar[Any]
    velocities_at_step_ends: ClassVar[Any] = False  # a step's displacement over its size

    @required
    def scheme(self) -> Any:
        """The scheme for the kernels: a member of :class:`TimeIntegrator`."""
