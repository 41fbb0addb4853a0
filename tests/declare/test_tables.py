"""Tables of designs: an array has the order of the inputs, of a frame the names decide."""

import numpy as np
import pandas as pd
import pytest

from snapjump.checks import ParameterError
from snapjump.composition import Simulation
from snapjump.declare.inputs import DEFAULT_INPUTS, inputs_of
from snapjump.declare.tables import rows_of

KNOWN = inputs_of(Simulation())
FOUR = [KNOWN[path] for path in DEFAULT_INPUTS]
ROWS = np.array([[0.1, 0.2, 0.768, 0.3], [0.05, 0.25, 1.2, 0.4]])


def rows(table):
    return rows_of(table, FOUR, KNOWN.values())


@pytest.mark.parametrize(
    "names",
    [
        ("delta_alpha_rad", "epsilon", "mass_bar", "mu"),
        ("delta_alpha", "epsilon", "mass_bar", "mu"),
        DEFAULT_INPUTS,
    ],
)
def test_names_decide_and_not_the_order(names):
    frame = pd.DataFrame(ROWS, columns=list(names))
    for order in ([0, 1, 2, 3], [3, 1, 0, 2]):
        np.testing.assert_array_equal(rows(frame.iloc[:, order]), ROWS)
    np.testing.assert_array_equal(rows(frame.assign(x_bar=1.0, status="ok")), ROWS)
    np.testing.assert_array_equal(rows(ROWS.tolist()), ROWS)


@pytest.mark.parametrize(
    ("columns", "told"),
    [
        (("delta_alpha", "eps", "mass_bar", "mu"), r"one column for design\.epsilon"),
        (("delta_alpha", "epsilon", "mass_bar"), r"one column for environment\.mu"),
        (("delta_alpha", "epsilon", "mass_bar", "mu", "design.epsilon"), r"one column for design"),
        (("delta_alpha", "epsilon", "mass_bar", "mu", "length_m"), r"or robot\.length_m among"),
    ],
)
def test_a_table_that_does_not_say_it_all_is_refused(columns, told):
    table = pd.DataFrame(np.ones((2, len(columns))), columns=list(columns))
    with pytest.raises(ParameterError, match=told):
        rows(table)


def test_an_array_of_another_shape_is_refused():
    with pytest.raises(ParameterError, match=r"shape \(R, 4\)"):
        rows(np.ones((2, 3)))
