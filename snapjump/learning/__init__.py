"""Learning the forward model from a dataset, keeping it, and asking it."""

from pathlib import Path

STANDARD = Path(__file__).parent / "trained" / "standard.safetensors"  # the one that comes along
