# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between a part of a document and one of a library, on parts of which that is known."""

import numpy as np
import pytest

from thinpart_workbench.api.classification import classify
from thinpart_workbench.api.window.part_difference import shown_difference, write_difference
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
from thinpart_workbench.storage.info.stored_records import single_record


def angle(length=60.0, hole=4.0):
    """An angle of 60 x 30 x 25 mm with a lug, so that it lies upon itself in one way only."""
    import FreeCAD as App
    import Part

    base, flange = Part.makeBox(length, 30, 4), Part.makeBox(4, 30, 25)
    lug = Part.makeBox(14, 8, 12, App.Vector(20, 22, 4))
    whole = base.fuse([flange, lug])
    if hole:
        whole = whole.cut(Part.makeCylinder(hole, 20, App.Vector(45, 12, -5)))
    return whole.removeSplitter()


def turned(shape):
    import FreeCAD as App

    shape = shape.copy()
    shape.Placement = App.Placement(App.Vector(210, -40, 9), App.Rotation(App.Vector(1, 2, 0.5), 77))
    return shape


@pytest.fixture
def compared(tmp_path, monkeypatch):
    """A function that compares two shapes, the second one in a file of a library."""
    from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
    from thinpart_workbench.freecad_adapter.reading.part_files import read_parts

    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))

    def compare(shape, other):
        snapshot = tmp_path / "snapshot"
        snapshot.mkdir()
        records = []
        for name, each in (("own", shape), ("other", other)):
            each.exportStep(str(tmp_path / f"{name}.step"))
            classify(tmp_path / f"{name}.step", write_info=True)
            records.append(single_record(str(tmp_path / f"{name}.step.thinpart.json")))
        part, = read_parts(str(tmp_path / "own.step")).parts
        list(write_snapshot([part], str(snapshot), AnalysisSettings(), {}))
        found = write_difference(str(snapshot), records[0], str(tmp_path / "other.step"),
                                 str(tmp_path / "other.step.thinpart.json"), records[1]["name"])
        return found, *shown_difference(str(snapshot))

    load_freecad()
    return compare


def apart(side):
    return side["corners"][side["is_apart"]].astype(float)


def areas(corners):
    sides = corners[:, 1:] - corners[:, :1]
    return 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)


def test_nothing_is_coloured_where_a_part_is_only_turned(compared):
    found, part, other = compared(angle(), turned(angle()))
    assert found["share"] == found["reference_share"] == 0.0 and found["greatest_mm"] < found["tolerance_mm"] < 0.05
    assert not part["is_apart"].any() and not len(other["corners"]) and not len(other["lines"])


def test_a_hole_of_the_other_is_its_wall_and_a_disc_on_both_sides(compared):
    found, part, other = compared(angle(hole=0.0), turned(angle(hole=4.0)))
    spots, tolerance = apart(part), found["tolerance_mm"]
    assert np.abs(spots[..., 2].min()) < 1e-4 and spots[..., 2].max() == pytest.approx(4.0, abs=1e-4)
    assert np.linalg.norm(spots[..., :2] - [45.0, 12.0], axis=-1).max() < 4.0 + 0.15
    assert areas(spots).sum() == pytest.approx(2.0 * np.pi * (4.0 - tolerance) ** 2, rel=0.02)
    wall = apart(other)
    assert np.linalg.norm(wall[..., :2] - [45.0, 12.0], axis=-1) == pytest.approx(4.0, abs=0.02)
    assert areas(wall).sum() == pytest.approx(2.0 * np.pi * 4.0 * 4.0, rel=0.03)
    assert found["greatest_mm"] == pytest.approx(4.0, abs=0.25)


def test_what_is_longer_is_coloured_at_its_end(compared):
    found, part, other = compared(angle(length=64.0), turned(angle()))
    end = apart(part)
    assert end[..., 0].min() > 59.6 and areas(end).sum() == pytest.approx(
        30 * 4 + 4 * (30 + 4) * 2, rel=0.03)  # the end, and 4 mm around it
    assert apart(other)[..., 0] == pytest.approx(60.0, abs=0.05)  # its own end, inside the part
    assert found["greatest_mm"] == pytest.approx(4.0, abs=0.02)


def test_a_mirror_image_is_shown_as_it_is(compared):
    import FreeCAD as App

    found, part, _ = compared(angle(), turned(angle().mirror(App.Vector(), App.Vector(1, 0, 0))))
    assert 0.02 < found["share"] < 0.6 and not part["is_apart"].all()


def test_a_document_that_is_gone_is_a_sentence(compared, tmp_path):
    compared(angle(), angle())
    (tmp_path / "other.step").unlink()
    records = [single_record(str(tmp_path / f"{name}.step.thinpart.json")) for name in ("own", "other")]
    with pytest.raises(ThinPartError, match="other.step"):
        write_difference(str(tmp_path / "snapshot"), records[0], str(tmp_path / "other.step"),
                         str(tmp_path / "other.step.thinpart.json"), records[1]["name"])
