"""The index of a library: an SQLite file that can be rebuilt from its info files."""
