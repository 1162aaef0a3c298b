# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hides the objects that a thickness map covers."""

import FreeCAD as App


class CoveredSources:
    """Hides objects in the 3D view without changing their Visibility property, which the document saves.

    Notes
    -----
    Two coincident surfaces would be drawn in patches. A user who hides and shows an object makes it visible again, until a
    map of it is asked for.
    """

    def __init__(self):
        self._covered = {}  # (document, object) -> whichChild of its switch; None if it was not hidden

    def cover(self, keys, shown_again=()):
        """Hide exactly these objects: a set of (document name, object name); some also where the user has shown them."""
        for key in keys:
            if key in shown_again and key in self._covered and _is_drawn(key):
                del self._covered[key]
        for key in list(self._covered):
            if key not in keys:
                self._uncover(key, self._covered.pop(key))
        for key in keys:
            if key not in self._covered:
                self._covered[key] = self._hide(key)

    def forget(self, name):
        """Drop the objects of a document that is being closed."""
        for key in [key for key in self._covered if key[0] == name]:
            del self._covered[key]

    def _hide(self, key):
        view = _view(key)
        if view is None or not view.Visibility:
            return None
        child = view.SwitchNode.whichChild.getValue()
        view.SwitchNode.whichChild = -1
        return child

    def _uncover(self, key, child):
        view = _view(key)
        if view is not None and child is not None and view.Visibility and (
                view.SwitchNode.whichChild.getValue() == -1):
            view.SwitchNode.whichChild = child


def _is_drawn(key):
    view = _view(key)
    return view is not None and view.SwitchNode.whichChild.getValue() != -1


def _view(key):
    document, name = key
    if document not in App.listDocuments():
        return None
    covered = App.getDocument(document).getObject(name)
    return getattr(covered, "ViewObject", None)
