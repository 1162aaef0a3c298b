# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of FreeCAD's Assembly workbench: its joints, links, views and lists beside the parts."""

from collections import Counter
from pathlib import Path

import pytest
from made_assemblies import BRACE, CASE, FOOT, LEAF, PIN, PLATE, has_assembly_workbench, save_assembly
from program import failures, records, thinpart

from thinpart_workbench.freecad_adapter.occurrences.occurrences import occurrence_matrices
from thinpart_workbench.freecad_adapter.reading.document_parts import document_content


@pytest.fixture
def made(freecad, tmp_path):
    """The assembly, saved and open."""
    if not has_assembly_workbench():
        pytest.skip("this FreeCAD has no Assembly workbench")
    made = save_assembly(tmp_path)
    yield made
    _shut(freecad)


def _shut(freecad):
    for name in list(freecad.listDocuments()):
        freecad.closeDocument(name)


def _instances(content):
    return {round(part.shape.Volume): part.instances for part in content.parts}


def test_each_distinct_solid_is_one_part_and_nothing_else_is(made, freecad):
    document = freecad.getDocument("Main")
    kinds = Counter(each.TypeId for each in document.Objects)
    assert kinds["Assembly::AssemblyLink"] == 2 and kinds["Assembly::BomObject"] == 1
    assert sum(hasattr(each, "JointType") for each in document.Objects) >= 1, "its own joint"
    assert sum(hasattr(each, "ObjectToGround") for each in document.Objects) == 1
    content = document_content(document)
    assert _instances(content) == made.instances and content.broken == []


def test_as_it_was_saved_too(made, freecad):
    _shut(freecad)
    content = document_content(freecad.openDocument(made.main))
    assert _instances(content) == made.instances and content.broken == []
    assert [part.warnings for part in content.parts] == [()] * len(made.instances)


def test_parts_stand_where_links_and_assemblies_place_them(made, freecad):
    document = freecad.getDocument("Main")
    parts = {round(part.shape.Volume): part for part in document_content(document).parts}
    # Joints move parts, and the links of an assembly that is not rigid have places of their own.
    def linked(assembly, name, *centre):
        owner = document.getObject(assembly)
        return {_rounded(owner.Placement.multVec(link.Placement.multVec(freecad.Vector(*centre))))
                for link in owner.Group if link.Name.startswith(name)}

    assert {volume: _centres(document, part) for volume, part in parts.items()} == {
        CASE: {(30.0, 25.0, -97.5)},
        FOOT: {(5.0, -195.0, 12.0)},
        BRACE: {(302.5, 2.5, 15.0), *linked("Loose", "Brace", 2.5, 2.5, 15.0)},
        PIN: {(2.0, 202.0, 10.0), (12.0, 202.0, 10.0), (22.0, 202.0, 10.0)},
        LEAF: {(6.0, 4.0, 300.5), (26.0, 4.0, 300.5), (356.0, 4.0, 0.5), (376.0, 4.0, 0.5),
               *linked("Loose", "SubHinge", 6.0, 4.0, 0.5), *linked("Loose", "SubHinge", 26.0, 4.0, 0.5)},
        PLATE: {(120.0, -1.0, 65.0), (320.0, 15.0, 1.0), *linked("Machine", "FirstPlate", 20.0, 15.0, 1.0),
                *linked("Stiff", "Upper", 20.0, 15.0, 1.0), *linked("Loose", "Lower", 20.0, 15.0, 1.0),
                *linked("Loose", "Upper", 20.0, 15.0, 1.0)},
    }


def _centres(document, part):
    """Where the centre of a part lies at each of its places, as a thickness map is placed."""
    centre = (*part.shape.CenterOfGravity, 1.0)
    return {_rounded((matrix @ centre)[:3]) for matrix in occurrence_matrices(document, part, part)}


def _rounded(point):
    return tuple(round(float(each), 3) + 0.0 for each in point)


def test_the_program_says_the_same(made, freecad):
    _shut(freecad)
    result = thinpart("classify", made.main, "--json")
    found = records(result)
    assert result.returncode == 0 and failures(result) == {}
    assert sorted(each["instances"] for each in found) == sorted(made.instances.values())


def test_an_assembly_whose_document_is_gone_is_one_failure(made, freecad):
    _shut(freecad)
    Path(made.sub).unlink()
    content = document_content(freecad.openDocument(made.main))
    assert [(each.name, each.kind) for each in content.broken] == [("Stiff", "missing"), ("Loose", "missing")]
    assert "leads to 'Frame' in Sub.FCStd" in content.broken[0].message
    assert _instances(content)[PLATE] == 2 and BRACE not in _instances(content)


def test_an_assembly_without_parts_has_none(made, freecad):
    document = freecad.newDocument("Bare")
    assembly = document.addObject("Assembly::AssemblyObject", "Assembly")
    joints = assembly.newObject("Assembly::JointGroup", "Joints")
    joints.newObject("App::FeaturePython", "Joint")
    assembly.newObject("Assembly::AssemblyLink", "Unset")
    document.recompute()
    content = document_content(document)
    assert content.parts == [] and content.broken == []
