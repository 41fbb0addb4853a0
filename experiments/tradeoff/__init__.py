"""What accuracy costs: every composition on one chart, and the tiers on it."""
