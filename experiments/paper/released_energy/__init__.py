"""What the snap releases, and how deep the arch hangs before it and after it."""
