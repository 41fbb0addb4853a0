"""Where runs are recorded: a family. MLflow is imported only when a record is written."""
