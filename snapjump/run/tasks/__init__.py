"""Tasks of the command line: a family, found by name."""
