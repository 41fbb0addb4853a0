"""Backends: how many robots are simulated at once, and on what."""
