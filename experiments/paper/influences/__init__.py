"""What each parameter does to the apex, one at a time about the baseline."""
