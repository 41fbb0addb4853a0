"""Whether results are the same to the last bit on other processors."""
