"""What is kept on disk. Adds nothing to what core imports."""
