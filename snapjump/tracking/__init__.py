"""Trackers, which record runs: a family. MLflow is imported only when a record is written."""
