"""Time integrators. A YAML file of a Runge-Kutta method's tableau is a member by itself."""

NUMBERS_ALONE = "parts.runge_kutta"  # the module that makes such a member
