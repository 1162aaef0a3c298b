"""The measured quantities of a part: their table, the thickness distribution, similarity."""
