"""The processes that are timed, and what they measure."""
