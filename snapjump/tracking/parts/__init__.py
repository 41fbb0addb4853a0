"""Records of jobs, and what trackers are made of."""
