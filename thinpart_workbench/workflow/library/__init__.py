"""Libraries of classified parts: search, similar parts, annotations, judging again."""
