"""Comparison of results, to the last bit, with other processors."""
