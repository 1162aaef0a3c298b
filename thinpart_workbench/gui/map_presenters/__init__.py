"""What a thickness map has, presented in the boxes of its panel: each box has its presenter."""
