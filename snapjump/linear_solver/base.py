"""Linear solvers of a Newton iteration: the contract that every one fulfils.

Given a :class:`snapjump.engine.work.System`, a solver replaces ``residual`` and
``frame_residual`` by the solution x of K x = residual and returns the number of pivots that are
not positive. It may destroy the matrix. Members: ``banded`` (all that compiled marches use).
"""
