"""Family: what the air does to a robot that moves."""
