"""Parts of frames, and frames that only a scene has."""
