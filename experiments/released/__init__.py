"""The released program's data against ours at its settings, and against the converged answer."""
