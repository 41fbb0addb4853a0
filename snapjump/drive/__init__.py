"""Family: how a robot is driven: clamps that turn, or a span that opens, over time."""
