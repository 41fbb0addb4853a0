"""``inverse=adam``: gradient descent on the forward model, as in the paper."""

import numpy as np
import torch
from scipy.stats import qmc

from snapjump.declare.fields import integer, number
from snapjump.inverse.base import InverseOptions, Problem, Solution, predicted_solutions


class AdamOptions(InverseOptions):
    """Adam on the forward model's squared miss, from several starts (the paper)."""

    starts: int = integer(16, least=1, most=4096)
    iterations: int = integer(300, least=1, most=1_000_000)
    learning_rate: float = number(0.03, above=0.0, most=1.0)

    def solve(self, problem: Problem) -> list[Solution]:
        """Ends of the descents. Source: the paper, its section on inverse design."""
        forward = problem.known_forward("adam")
        span = problem.high - problem.low
        shares = torch.from_numpy(qmc.Sobol(2, rng=problem.seed).random(self.starts))
        optimizer = torch.optim.Adam([shares], lr=self.learning_rate)
        # A constant rate would keep on circling the root.
        rate = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, self.iterations)
        for _ in range(self.iterations):
            designs = problem.designs(problem.unscaled(shares.numpy()))
            missed = forward.predict(designs) - problem.target
            slopes = forward.jacobian(designs)[:, :, :2] * span
            shares.grad = torch.from_numpy(2.0 * np.einsum("sij,si->sj", slopes, missed))
            optimizer.step()
            rate.step()
            shares.clamp_(0.0, 1.0)
        return predicted_solutions(problem, forward, problem.unscaled(shares.numpy()))
