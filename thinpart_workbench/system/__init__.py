"""Differences between Linux, macOS and Windows, one topic per module; independent of parts."""
