"""How fast results converge, in time step, mesh and the numbers of contact and friction."""
