"""Many jumps of one composition side by side: SIMD lanes times threads, one queue."""

from snapjump.batch.derivatives import model_derivatives
from snapjump.batch.outcome import Batch
from snapjump.batch.prepare import Prepared, prepare_designs
from snapjump.batch.simulate import simulate_batch, simulate_designs
from snapjump.batch.variants import variant, variants

__all__ = [
    "Batch",
    "Prepared",
    "model_derivatives",
    "prepare_designs",
    "simulate_batch",
    "simulate_designs",
    "variant",
    "variants",
]
