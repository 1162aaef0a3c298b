# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings one thickness map of a document to be seen."""

from ...freecad_adapter.objects.thickness_object import thickness_objects
from ..application import lifelong


def show_alone(thickness):
    """Show a map where it was hidden, and hide what would be drawn in the same place: its sources, and other maps of them.

    Notes
    -----
    A map may have been hidden by 'Classify', or by the user, who may also have shown its sources again meanwhile. Two
    surfaces in one place are drawn in patches, or the part's own colours over those of the map.
    """
    for other in thickness_objects(thickness.Document):
        if other != thickness and other.ViewObject.Visibility and not set(_names(other)).isdisjoint(_names(thickness)):
            other.ViewObject.Visibility = False
    if not thickness.ViewObject.Visibility:
        thickness.ViewObject.Visibility = True
    lifelong.map_events.cover_again(_names(thickness))


def _names(thickness):
    """``(document, object)`` names of the source objects of a map: list of tuple."""
    return [(source.Document.Name, source.Name) for source in thickness.Sources if source is not None]
