"""The extremes: what becomes of a jump, and of its own error estimate, far from the defaults."""
