"""Where the paper's settings and the converged answer differ, and which choice makes how much."""
