"""Facts that are declared once, and read by whatever checks, sweeps, draws or documents them."""
