"""Accuracy and cost of the sensitivities."""
