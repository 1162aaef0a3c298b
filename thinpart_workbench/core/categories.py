"""The two categories that no profile defines; importable without numpy."""

NORMAL, UNKNOWN = "normal", "unknown"
"""What no criterion holds of; what could not be measured well enough to tell."""
