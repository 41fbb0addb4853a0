"""Source files, and hashes of what they say, by which results and kernels are told apart."""
