"""Every family and its members by name: what can be composed, in one place."""
