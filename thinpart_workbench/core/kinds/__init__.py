"""Kinds of values in files, and the checks compiled from them."""
