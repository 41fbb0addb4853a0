"""What both figures of snaps are about."""

EPSILON, MISMATCH = 0.1, 0.1  # the paper's; the mismatch in rad
