"""The achievable region against mass and friction."""
