"""The dialog that writes a report."""
