"""The command 'Show thickness' and the boxes of its panel."""
