"""Sampling plans: which designs a dataset has, any stretch of them without the rest."""
