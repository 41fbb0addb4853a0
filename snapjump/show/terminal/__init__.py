"""What the terminal shows: the help page, a progress bar, the closing block, tables."""
