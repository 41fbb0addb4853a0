"""Executors: where the pieces of a long computation are done."""
