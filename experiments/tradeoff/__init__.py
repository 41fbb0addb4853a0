"""Accuracy against cost: every composition on one chart, and the tiers on it."""
