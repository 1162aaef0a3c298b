"""The dialog that learns thresholds from labels."""
