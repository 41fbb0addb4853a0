"""How far off a jump is by its model: what robot and laws are described by is never quite known."""
