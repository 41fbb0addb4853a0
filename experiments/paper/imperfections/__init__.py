"""The apex against errors of the robot and of the ground."""
