"""Scalars that every lane carries through a march: rows of ``Work.clock``."""

TIME = 0  # at the step's beginning (T)
STEP = 1  # its size h (T)
STAGE = 2  # the implicit stage being solved, from 1
ITERATION = 3  # Newton iterations of this stage so far
SIZE = 4  # size of the last Newton correction (L)
SHARE = 5  # share of it that was taken
BACKTRACKS = 6  # of this stage
FAILURES = 7  # Newton failures in a row
ACTIVE = 8  # 1 while the lane carries a robot
STEPS = 9  # accepted so far
REJECTED = 10  # steps so far
ITERATIONS = 11  # Newton iterations in all
SMALLEST_GAP = 12  # at any accepted stage (L)
LARGEST_RESIDUAL = 13  # that Newton's method left in a stage, over the forces in play; if recorded
STATUS = 14  # one of snapjump.engine.status, 0 while running
ERROR = 15  # estimate of the step being judged (L)
FASTEST = 16  # contact frequency at the last assembly (1/T)
RESIDUAL = 17  # of the last assembly, over the forces in play
GAP = 18  # smallest at the last assembly (L)
LAST_CONTACT = 19  # end of the last step that ended in contact (T)
COM_X = 20  # centre of mass when the robot left the march (L)
COM_Y = 21
COM_VX = 22  # its velocity (L/T)
COM_VY = 23
ROWS = 24
