"""Friction at rest, for statics."""
