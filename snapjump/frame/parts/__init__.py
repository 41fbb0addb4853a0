"""What frames are made of, and frames that only a scene has."""
