"""The beam between its clamps: equilibria, snaps, and independent solutions of both."""
