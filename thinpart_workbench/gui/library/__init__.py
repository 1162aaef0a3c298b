"""The dock that finds parts in libraries."""
