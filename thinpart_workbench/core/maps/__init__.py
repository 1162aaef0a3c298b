"""Thickness maps: the thickness field as it is shown, searched and summed up."""
