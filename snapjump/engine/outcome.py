"""Outcome of a robot's march: columns of ``Queue.outcome``, from its lane's clock in the end."""

from snapjump.engine import clock

(
    STATUS,  # one of snapjump.engine.status
    TIME,  # at the end of its last step (T)
    STEP,  # size of the step that it would have taken next (T)
    STEPS,  # accepted
    REJECTED,
    ITERATIONS,  # of Newton's method
    FAILURES,  # of Newton's method in a row, at the end
    SMALLEST_GAP,  # at any accepted stage (L)
    LARGEST_RESIDUAL,  # that Newton's method left in a stage, over the forces in play; if recorded
    LAST_CONTACT,  # end of the last step that ended in contact (T)
    COM_X,  # centre of mass (L)
    COM_Y,
    COM_VX,  # its velocity (L/T)
    COM_VY,
    ERROR_SUM,  # estimates of all steps that stood, added up (L)
    COARSEST,  # largest step that stood, times the contact frequency in it
    SMALLEST_STABLE_STEP,  # of an explicit scheme (T)
    SPIN,  # mean rate of rotation in flight (rad/T)
) = range(18)

ROWS_OF_CLOCK = (
    clock.STATUS,
    clock.TIME,
    clock.STEP,
    clock.STEPS,
    clock.REJECTED,
    clock.ITERATIONS,
    clock.FAILURES,
    clock.SMALLEST_GAP,
    clock.LARGEST_RESIDUAL,
    clock.LAST_CONTACT,
    clock.COM_X,
    clock.COM_Y,
    clock.COM_VX,
    clock.COM_VY,
    clock.ERROR_SUM,
    clock.COARSEST,
    clock.SMALLEST_STABLE_STEP,
    clock.SPIN,
)
COLUMNS = len(ROWS_OF_CLOCK)
