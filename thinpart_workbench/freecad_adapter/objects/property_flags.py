# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD does with a property of an object: flags of `addProperty`."""

_READ_ONLY, _HIDES, _OUTPUT, _NO_RECOMPUTE = 1, 4, 8, 16  # App::PropertyType

SHOWN_ONLY = _NO_RECOMPUTE
"""A change shows at once and triggers no recompute."""

COMPUTED = _READ_ONLY | _OUTPUT | _NO_RECOMPUTE
"""Read-only, an output of the object, and triggers no recompute."""

HIDDEN = _HIDES
"""Not in the property editor."""
