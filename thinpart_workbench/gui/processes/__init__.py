"""Child processes of the GUI."""
