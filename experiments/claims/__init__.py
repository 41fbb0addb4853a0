"""What jumps claim of their own accuracy, held against the truth, far from the paper's ranges too."""
