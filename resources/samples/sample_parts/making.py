# SPDX-License-Identifier: LGPL-2.1-or-later
"""Building a sample, checking it, and saving it as a document and as STEP."""

import os
import tempfile

import FreeCAD
import Part

from .document_file import finish_document, view_of
from .step_file import write_step


class BadSample(RuntimeError):
    """A part that did not come out as intended."""


def make(sample, folder):
    """Build one sample, check it, save both files, and check what was saved.

    Parameters
    ----------
    sample : Sample
    folder : str

    Returns
    -------
    (Part.Shape, int, int)
        The shape, and the bytes of the document and of the STEP file.

    Raises
    ------
    BadSample
    """
    document = FreeCAD.newDocument(sample.name)
    results = sample.build(document)
    document.recompute()
    _check_objects(sample.name, document.Objects)
    shape = _shape_of(results)
    _check_shape(sample.name, shape, sample.solids)
    volume = shape.Volume

    step = os.path.join(folder, sample.name + ".step")
    write_step(shape, step, sample.name)
    _check_shape(step, Part.read(step), sample.solids, volume)

    fcstd = os.path.join(folder, sample.name + ".FCStd")
    document.License = "The license of the ThinPart workbench"
    document.LicenseURL = ""
    names = [each.Name for each in results]
    view = view_of(document, shape.BoundBox)
    # Saved elsewhere first: FreeCAD would leave a backup beside a file that it overwrites.
    with tempfile.TemporaryDirectory() as scratch:
        saved = os.path.join(scratch, sample.name + ".FCStd")
        document.saveAs(saved)
        FreeCAD.closeDocument(document.Name)
        finish_document(saved, fcstd, sample.name, view)
    document = FreeCAD.openDocument(fcstd)
    results = [document.getObject(name) for name in names]
    _check_shape(fcstd, _shape_of(results), sample.solids, volume)
    FreeCAD.closeDocument(document.Name)
    return shape, os.path.getsize(fcstd), os.path.getsize(step)


def _shape_of(results):
    """The results' shape, placements of containers and links included."""
    shapes = [Part.getShape(each) for each in results]
    shape = shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    return shape.Solids[0] if len(shape.Solids) == 1 else shape


def _check_objects(name, objects):
    broken = [each.Label for each in objects if "Invalid" in each.State or not each.isValid()]
    if broken:
        raise BadSample(f"{name}: cannot compute {', '.join(broken)}")
    sketches = [each for each in objects if each.isDerivedFrom("Sketcher::SketchObject")]
    loose = [each.Label for each in sketches if each.solve() != 0 or not each.FullyConstrained]
    if loose:
        raise BadSample(f"{name}: not fully constrained: {', '.join(loose)}")


def _check_shape(what, shape, solids, volume=None):
    """Raise BadSample unless `shape` is valid and has so many solids (and this volume)."""
    if shape.isNull() or not shape.isValid():
        raise BadSample(f"{what}: the shape is not valid")
    if len(shape.Solids) != solids:
        raise BadSample(f"{what}: {len(shape.Solids)} solids instead of {solids}")
    if any(solid.Volume <= 0 or not solid.isClosed() for solid in shape.Solids):
        raise BadSample(f"{what}: a solid is open or inside out")
    if len(shape.Faces) != sum(len(solid.Faces) for solid in shape.Solids):
        raise BadSample(f"{what}: there are faces outside of the solids")
    if volume is not None and abs(shape.Volume - volume) > 1e-4 * volume:
        raise BadSample(f"{what}: volume {shape.Volume:g} instead of {volume:g}")
