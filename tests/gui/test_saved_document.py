# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that an earlier version has saved: they name classes of ThinPart by the modules that these were in."""

import shutil
from pathlib import Path

import FreeCAD as App
import pytest
import window_actions as window
from thickness_window import bar_rows, look_at, picture

from thinpart_workbench.core.rendering.colour_maps import COLOUR_MAPS
from thinpart_workbench.freecad_adapter.objects.thickness_object import ThicknessObject, thickness_objects
from thinpart_workbench.gui.view3d.view_provider import ThicknessView

SAVED = Path(__file__).resolve().parent / "saved" / "map_of_a_plate.FCStd"
"""A plate of 20 x 12 x 2 mm and its map, saved by ThinPart in FreeCAD 0.20 while all of gui was one folder."""


@pytest.fixture
def thickness(tmp_path):
    document = App.openDocument(shutil.copy(SAVED, tmp_path))
    window.settle(60)
    found, = thickness_objects(document)
    return found


def test_a_map_is_seen_as_it_was_saved(thickness, tmp_path):
    assert type(thickness.Proxy) is ThicknessObject and type(thickness.ViewObject.Proxy) is ThicknessView
    assert thickness.Thinnest == pytest.approx(2.0) and not thickness.Stale
    assert bar_rows(picture(look_at(thickness.Document), tmp_path, 800, 600))


def test_it_keeps_its_colours_and_offers_the_newer_ones(thickness, tmp_path):
    assert thickness.ColourMap == "viridis" and not thickness.Shaded and not thickness.Logarithmic
    assert tuple(thickness.getEnumerationsOfProperty("ColourMap")) == COLOUR_MAPS
    flat = picture(look_at(thickness.Document), tmp_path, 800, 600)
    thickness.Shaded, thickness.ColourMap = True, "red is thin"
    assert picture(look_at(thickness.Document), tmp_path, 800, 600) != flat
    thickness.Document.saveAs(str(tmp_path / "again.FCStd"))
    App.closeDocument(thickness.Document.Name)
    found, = thickness_objects(App.openDocument(str(tmp_path / "again.FCStd")))
    assert found.Shaded and found.ColourMap == "red is thin"


def test_its_panel_opens_and_it_is_measured_again_when_it_is_recomputed(thickness):
    assert thickness.ViewObject.Proxy.doubleClicked(thickness.ViewObject)
    # An earlier version had measured parallel walls only.
    window.wait_until(lambda: "Thinnest parallel wall 2" in window.text("ThinPart_Walls"))
    thickness.Document.getObject("Plate").Shape = thickness.Document.getObject("Plate").Shape.scaled(2.0)
    thickness.Document.recompute()
    assert thickness.Stale
    thickness.touch()
    thickness.Document.recompute()
    window.wait_until(lambda: "Thinnest wall 4" in window.text("ThinPart_Walls") and not thickness.Stale)
