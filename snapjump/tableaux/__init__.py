"""Butcher tableaux as configurations: one YAML a method, found by the library and by Hydra."""
