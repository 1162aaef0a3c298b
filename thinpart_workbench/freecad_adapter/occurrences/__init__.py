"""From parts to their occurrences in a document and back."""
