"""Automatic classification of documents when they are saved."""
