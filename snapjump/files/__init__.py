"""What a job leaves on disk: every file whole or not at all."""
