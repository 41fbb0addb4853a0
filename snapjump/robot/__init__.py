"""The robot, its design and its environment."""
