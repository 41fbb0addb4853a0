"""Many jumps of one composition side by side: SIMD lanes times threads, one queue."""

from snapjump.batch.derivatives import model_derivatives as model_derivatives
from snapjump.batch.outcome import Batch as Batch
from snapjump.batch.prepare import Prepared as Prepared
from snapjump.batch.prepare import prepare_designs as prepare_designs
from snapjump.batch.simulate import simulate_batch as simulate_batch
from snapjump.batch.simulate import simulate_designs as simulate_designs
from snapjump.batch.variants import variant as variant
from snapjump.batch.variants import variants as variants
