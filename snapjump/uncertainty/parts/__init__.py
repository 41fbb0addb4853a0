"""What members of the family are made of."""
