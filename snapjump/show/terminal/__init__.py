"""Text for the terminal: the help page, a progress bar, the closing block, tables."""
