"""Find the feature of a document that made a face."""
