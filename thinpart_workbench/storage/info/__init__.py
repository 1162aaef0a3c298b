"""Info files: their definition, reading and writing, and the annotations in them."""
