"""What another profile would change in libraries, and writing it."""
