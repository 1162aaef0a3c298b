"""The section plane of a thickness map."""
