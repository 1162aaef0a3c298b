# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities and conditions of profiles in words, for people who read or edit a profile."""

from ..descriptors.quantity import AreaShare, LocalShare, MiddleShare, WallDistance
from ..message import Message, message


def quantity_text(quantity):
    """What a quantity is, with its bounds: str, a Message where it has some."""
    if not quantity.bounds:
        return quantity.meaning
    low, high = quantity.bounds
    if isinstance(quantity, WallDistance):
        return message("Least distance, in diagonals, between walls at {low:g} to {high:g} degrees", low=low, high=high)
    if isinstance(quantity, LocalShare):
        if low == 0.0:
            return message("Share of the surface whose local thickness is under {high:g} of the middle side", high=high)
        return message("Share of the surface whose local thickness is {low:g} to {high:g} of the middle side",
                       low=low, high=high)
    if isinstance(quantity, MiddleShare):
        return _of_middle_side(quantity.slanted, low, high)
    if isinstance(quantity, AreaShare):
        if low == 0.0:
            return message("Share of the surface over parallel walls thinner than {high:g} of the diagonal", high=high)
        return message("Share of the surface over parallel walls {low:g} to {high:g} of the diagonal thick",
                       low=low, high=high)
    return Message(quantity.meaning, {})


def _of_middle_side(slanted, low, high):
    if slanted and low == 0.0:
        return message("Share of the surface over walls, parallel or tapered, thinner than {high:g} of the middle side",
                       high=high)
    if slanted:
        return message("Share of the surface over walls, parallel or tapered, {low:g} to {high:g} of the middle side thick",
                       low=low, high=high)
    if low == 0.0:
        return message("Share of the surface over parallel walls thinner than {high:g} of the middle side", high=high)
    return message("Share of the surface over parallel walls {low:g} to {high:g} of the middle side thick",
                   low=low, high=high)
