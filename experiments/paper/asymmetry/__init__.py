"""How far a mismatch between the clamps turns the midpoint."""
