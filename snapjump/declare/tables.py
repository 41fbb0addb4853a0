"""Tables of designs: arrays in the order of their inputs, and frames whose columns have names."""

from collections.abc import Iterable, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from snapjump.checks import ParameterError, is_finite_number


class Named(Protocol):
    """An input, or an axis of a dataset: a path, and a name in files."""

    @property
    def path(self) -> str: ...

    @property
    def column(self) -> str: ...


def names_of(one: Named) -> set[str]:
    """What a column may be called: the path, the name in files, the last word of the path."""
    return {one.path, one.path.replace(".", "_"), one.column, one.path.rpartition(".")[2]}


def rows_of(
    designs: Any, inputs: Sequence[Named], others: Iterable[Named] = ()
) -> NDArray[np.float64]:
    """Designs (R, I), their columns in the order of the inputs.

    An array is in that order. Of a table with named columns (a pandas DataFrame) the names decide,
    whatever their order; columns that are no inputs may be there too.

    Raises ParameterError for an array of another shape, and for a table that lacks an input, has
    it twice, or has one of the ``others``, which would otherwise be left out.
    """
    paths = [one.path for one in inputs]
    names = ", ".join(paths)
    columns = getattr(designs, "columns", None)
    if columns is None:
        rows = numbers_of(designs)
        if rows.ndim != 2 or rows.shape[1] != len(inputs):
            raise ParameterError(
                "designs", rows.shape, f"rows of {names}: shape (R, {len(inputs)})"
            )
        return rows
    known = [str(column) for column in columns]
    places = []
    for one in inputs:
        found = [k for k, column in enumerate(known) if column in names_of(one)]
        if len(found) != 1:
            told = f"one column for {one.path}, called {' or '.join(sorted(names_of(one)))}"
            raise ParameterError("designs", ", ".join(known), told)
        places += found
    for one in others:
        for column in names_of(one) & set(known):
            if one.path not in paths and known.index(column) not in places:
                raise ParameterError(
                    "designs", column, f"columns of {names}, or {one.path} among the inputs too"
                )
    return np.column_stack([numbers_of(designs.iloc[:, k]) for k in places])


def numbers_of(values: Any) -> NDArray[np.float64]:
    """An array of floats. Raises ParameterError for texts, complex numbers and truth values."""
    found = np.asarray(values)
    if found.dtype.kind == "O":  # a mixture: each for itself
        numeric = all(is_finite_number(one) or one != one for one in found.ravel())
    else:
        numeric = found.dtype.kind in "fiu"
    if not numeric:
        raise ParameterError("designs", str(found.dtype), "numbers")
    return found.astype(float)
