"""The colours of thickness maps, and the colour bar."""
