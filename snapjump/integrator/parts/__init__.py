"""Runge-Kutta methods: every YAML file of a tableau beside this folder is one."""
