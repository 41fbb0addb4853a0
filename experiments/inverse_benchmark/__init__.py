"""The paper's protocol for inverse design: random environments, reachable targets, every method."""
