"""Statuses of simulations: by number in the kernels and by name outside."""

RUNNING = 0
OK = 1
NO_JUMP = 2
STEP_UNDERFLOW = 3
ITERATION_LIMIT = 4
TIME_LIMIT = 5
NOT_FINITE = 6
NO_EQUILIBRIUM = 7
ENERGY_GAINED = 8
MOMENTUM_GAINED = 12
# Of designs in a batch, which are refused one by one where a single one is an error.
BAD_DESIGN = 9
NO_THRESHOLD = 10
# Of a bounce.
IN_CONTACT = 11
# Of an arch alone.
NO_SNAP = 13
BRANCH_LOST = 14

NAMES = {
    OK: "ok",
    NO_JUMP: "no_jump",
    STEP_UNDERFLOW: "step_underflow",
    ITERATION_LIMIT: "iteration_limit",
    TIME_LIMIT: "time_limit",
    NOT_FINITE: "not_finite",
    NO_EQUILIBRIUM: "no_equilibrium",
    ENERGY_GAINED: "energy_gained",
    MOMENTUM_GAINED: "momentum_gained",
    BAD_DESIGN: "bad_design",
    NO_THRESHOLD: "no_threshold",
    IN_CONTACT: "in_contact",
    NO_SNAP: "no_snap",
    BRANCH_LOST: "branch_lost",
}

REASONS = {
    OK: "",
    NO_JUMP: "the robot did not leave the ground",
    STEP_UNDERFLOW: "Newton's method failed however small the step",
    ITERATION_LIMIT: "the bound on Newton iterations was reached",
    TIME_LIMIT: "the scene did not end within its time limit",
    NOT_FINITE: "a number was not finite",
    NO_EQUILIBRIUM: "no stable equilibrium to start from was found",
    ENERGY_GAINED: "the steps put energy in: the apex is beyond what the beam could have held",
    MOMENTUM_GAINED: "the robot left with more momentum along the ground than friction can give",
    BAD_DESIGN: "a value of the design lies outside its range, or its parts do not fit each other",
    NO_THRESHOLD: "the arch of this pre-compression does not buckle, or does not snap",
    IN_CONTACT: "the duration ended while the mass was still in contact",
    NO_SNAP: "the arch did not snap through",
    BRANCH_LOST: "the branch of equilibria could not be followed until the arch snaps",
}
