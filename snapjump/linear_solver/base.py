"""Linear solvers of a Newton iteration: the contract that every one fulfils.

A solver takes the nodes of a :class:`snapjump.engine.work.System` one after the other, as soon as
their columns and their share of the border are complete (``begin_elimination``,
``eliminate_node``); then ``solve_frame`` and ``substitute_back`` replace ``frame_residual`` and
``residual`` by the solution x of K x = residual. It counts the pivots that are not positive and
may destroy the matrix. Members: ``banded`` (all that compiled marches use).
"""
