"""Trajectories of the centre of mass, and the angle at which the robot leaves."""
