"""The open documents: observers, selection, measurement and the open task panel."""
