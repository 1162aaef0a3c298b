"""The editor of profiles and of limits of the wall."""
