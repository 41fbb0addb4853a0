"""The paper's dataset, forward model and inverse design, made anew from nothing."""
