"""Random designs far outside the paper's ranges, and random nonsense: what becomes of them."""
