"""Forward models compared: by data, by architecture, and with what no smooth model can learn."""
