"""What lanes and threads buy, and where the time goes: ``python -m experiments.scaling``."""
