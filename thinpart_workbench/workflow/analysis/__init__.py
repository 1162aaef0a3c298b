"""The flow for one file, and runs over many files."""
