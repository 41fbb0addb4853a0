"""What a user describes: the robot, its design and its environment."""
