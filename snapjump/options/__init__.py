"""The options of every module, with units: one dataclass a member, one file a family.

Options are what users set and what is checked; each turns itself into the dimensionless member
that the kernels compute with.
"""
