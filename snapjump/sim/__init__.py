"""Scenes: which bodies and terms exist, when a simulation ends, and what it reports."""
