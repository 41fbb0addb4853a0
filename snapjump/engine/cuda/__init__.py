"""Jumps on a graphics card: the engine's own functions, compiled for one robot a thread."""
