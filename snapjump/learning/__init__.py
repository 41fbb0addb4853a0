"""Learning the forward model from a dataset, keeping it, and asking it."""
