"""What each scene leaves out, and what that saves and changes."""
