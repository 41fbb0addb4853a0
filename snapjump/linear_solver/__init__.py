"""The linear solver of a Newton iteration: banded elimination with a border.

Nodes are eliminated one after the other, as soon as their columns and their share of the border are
complete; the frame's block is solved last, and substitution replaces ``frame_residual`` and
``residual`` by the solution x of K x = residual. Pivots that are not positive are counted, and the
matrix is used up.
"""
