"""Elastic frequencies of parts by CalculiX, and how far those of the automatic mesh are off."""
