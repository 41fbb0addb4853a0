"""``python run.py task=paper``: the paper's figures and statements, by simulation, one by one."""
