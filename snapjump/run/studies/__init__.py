"""Studies: many computations, kept one by one, that come to tables, figures and a finding."""
