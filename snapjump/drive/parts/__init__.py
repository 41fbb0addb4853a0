"""What drives are made of."""
