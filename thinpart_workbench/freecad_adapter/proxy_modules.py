# SPDX-License-Identifier: LGPL-2.1-or-later
"""The modules of ThinPart that documents name: those of the Python objects (proxies) in documents."""

OWN_PACKAGE = __package__.partition(".")[0]

PROXY_MODULES = frozenset(f"{OWN_PACKAGE}.{name}" for name in (
    "freecad_adapter.objects.thickness_object", "freecad_adapter.objects.wall_measurement", "gui.view3d.view_provider",
    # Where these classes were in earlier versions.
    "freecad_adapter.thickness_object", "freecad_adapter.wall_measurement", "gui.thickness_view",
))
"""FreeCAD imports them when it opens a document. No other module of ThinPart has a reason to be named there."""
