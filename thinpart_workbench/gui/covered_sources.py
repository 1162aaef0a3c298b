"""Objects that are not drawn because a thickness map covers them."""

import FreeCAD as App


class CoveredSources:
    """Keeps objects out of the 3D view without touching their visibility, which is saved in the document.

    Notes
    -----
    Two surfaces at one place would be seen in patches. Who hides and shows an object meanwhile sees it.
    """

    def __init__(self):
        self._covered = {}  # (document, object) -> what its switch showed; None where nothing was done

    def cover(self, wanted):
        """Cover these objects, and no others any more: set of names of document and object."""
        for key in list(self._covered):
            if key not in wanted:
                self._uncover(key, self._covered.pop(key))
        for key in wanted:
            if key not in self._covered:
                self._covered[key] = self._hide(key)

    def forget(self, name):
        """A document is closed."""
        for key in [key for key in self._covered if key[0] == name]:
            del self._covered[key]

    def _hide(self, key):
        view = _view(key)
        if view is None or not view.Visibility:
            return None
        shown = view.SwitchNode.whichChild.getValue()
        view.SwitchNode.whichChild = -1
        return shown

    def _uncover(self, key, shown):
        view = _view(key)
        if view is not None and shown is not None and view.Visibility and (
                view.SwitchNode.whichChild.getValue() == -1):
            view.SwitchNode.whichChild = shown


def _view(key):
    document, name = key
    if document not in App.listDocuments():
        return None
    found = App.getDocument(document).getObject(name)
    return getattr(found, "ViewObject", None)
