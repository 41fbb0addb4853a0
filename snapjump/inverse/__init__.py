"""Methods that find designs for a target, one file each."""
