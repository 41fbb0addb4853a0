"""One-step integrators: diagonally implicit Runge-Kutta methods, one Butcher tableau each.

Every member fulfils one contract: stage 0 is the (explicit) beginning of the step, stages
1 ... S - 1 solve the shared stage problem (:mod:`snapjump.engine.assemble`) with the same diagonal
coefficient gamma, and the last stage is the end of the step (stiffly accurate), so that whatever a
stage guards, the end point guards too.
"""

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray


class Tableau(NamedTuple):
    """A Butcher tableau for the kernels.

    gamma: diagonal coefficient; matrix (S, S) strictly lower part by which earlier stages enter;
    nodes (S); weights (S): the last row; error (S): weights minus those of a comparison method,
    a tuple, so that kernels know the number of stages while they are compiled.
    """

    gamma: float
    matrix: NDArray[np.float64]
    nodes: NDArray[np.float64]
    weights: NDArray[np.float64]
    error: tuple[float, ...]
    error_order: float


@dataclass(frozen=True)
class Integrator:
    """Base of all members; the class attributes declare what a test measures.

    ``rows``: the tableau's rows, stage 0 first. ``order``: of accuracy. ``damping_at_infinity``:
    amplification of an infinitely fast oscillation (0 if L-stable).
    """

    rows: ClassVar[tuple[tuple[float, ...], ...]]
    order: ClassVar[int]
    damping_at_infinity: ClassVar[float]

    def tableau(self) -> Tableau:
        """The tableau, with an error estimate by the quadrature of highest order on its nodes."""
        full = np.zeros((len(self.rows), len(self.rows)))
        for i, row in enumerate(self.rows):
            full[i, : len(row)] = row
        nodes = full.sum(axis=1)
        powers = np.arange(len(nodes))
        interpolatory = np.linalg.solve(nodes[None, :] ** powers[:, None], 1.0 / (powers + 1.0))
        gamma = full[1, 1]
        return Tableau(
            gamma=float(gamma),
            matrix=np.tril(full, -1),
            nodes=nodes,
            weights=full[-1].copy(),
            error=tuple(float(e) for e in full[-1] - interpolatory),
            error_order=float(self.order + 1),
        )
