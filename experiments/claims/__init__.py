"""What jumps claim of their own accuracy, held against the truth, beyond the paper's ranges too."""
