"""What statics have instead of a friction law."""
