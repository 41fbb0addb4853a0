"""Parts of executors."""
