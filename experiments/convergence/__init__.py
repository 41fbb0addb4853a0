"""Convergence of results in time step, mesh and the numbers of contact and friction."""
