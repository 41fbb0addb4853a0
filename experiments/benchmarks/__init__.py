"""Numbers of the literature, beside those of this library."""
