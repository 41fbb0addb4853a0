"""Throughput by lanes and threads, and a profile of a pass: ``python -m experiments.scaling``."""
