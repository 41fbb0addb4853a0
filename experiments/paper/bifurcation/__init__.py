"""Equilibria of the arch whose clamps turn alike: branches, their stability, the loop."""
