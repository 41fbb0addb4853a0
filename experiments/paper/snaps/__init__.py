"""The symmetric and the asymmetric snap, and what breaks the symmetry."""
