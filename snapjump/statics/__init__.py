"""Static equilibria of the clamped arch: branches, stability, critical angles."""
