"""Read files and documents, and reject unsafe or damaged ones."""
