"""What ThinPart does with documents: the flow, and its consumers."""
