"""Worker processes: the pool, its messages, JSON lines, temporary folders."""
