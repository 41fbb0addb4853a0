"""What surrogates are made of."""
