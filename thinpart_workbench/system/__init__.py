"""What Linux, macOS and Windows do differently, each in one module; it knows nothing of parts."""
