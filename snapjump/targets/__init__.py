"""Targets for designs: what can be reached, what a design really reaches, and how surely."""
