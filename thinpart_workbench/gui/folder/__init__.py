"""The dialog that classifies a folder."""
