"""The command 'Classify part' and its panel."""
