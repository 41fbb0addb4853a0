"""What the command line can be asked to do: a family, found by name."""
