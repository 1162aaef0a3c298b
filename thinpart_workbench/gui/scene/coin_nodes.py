# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes that most scene graphs of ThinPart have, and adding them to others."""

from pivy import coin


def add_children(group, *nodes):
    """Add nodes to a group, one after the other."""
    for node in nodes:
        group.addChild(node)


def put_into(root, node):
    """Add a node to a scene graph, unless it is there."""
    if root.findChild(node) < 0:
        root.addChild(node)


def take_out_of(root, node):
    """Remove a node from a scene graph, if it is there."""
    if root.findChild(node) >= 0:
        root.removeChild(node)


def unpickable():
    """SoPickStyle: the mouse does not find what follows."""
    style = coin.SoPickStyle()
    style.style = coin.SoPickStyle.UNPICKABLE
    return style


def flat_colours():
    """SoLightModel: what follows has its own colours, whatever the light."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def colour_per_vertex():
    """SoMaterialBinding: each vertex of what follows has its own colour."""
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.PER_VERTEX_INDEXED
    return binding


def painted(rgb):
    """SoBaseColor of red, green and blue from 0 to 1."""
    colour = coin.SoBaseColor()
    colour.rgb = rgb
    return colour


def skipped_by_fit_all():
    """A group class of FreeCAD, whose children "fit all" ignores."""
    group = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
    group.set("mode EXCLUDE_BBOX")
    return group
