# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps of the parts of a document, measured here and now."""

import numpy as np

from thinpart_workbench.api.document_maps import new_thickness_object
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.freecad_adapter.reading.document_parts import document_parts

SETTINGS = AnalysisSettings()


def mapped_parts(document):
    """list of MappedPart of all parts, each at all its places."""
    return [_mapped(document, part) for part in document_parts(document)]


def add_map(document, *sources):
    """A thickness object of all parts of a document, stale where one of the sources changes."""
    return new_thickness_object(document, list(sources), mapped_parts(document))


def _mapped(document, part):
    mesh, _ = part.surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    measurement = measure(mesh, SETTINGS)
    record = {"name": part.name, "label": part.label, "thin_limit_mm": 7.0,
              "descriptors": {"diagonal_mm": measurement.descriptors.box.diagonal}}
    return MappedPart(record, thickness_map(measurement), [], _places(document, part))


def _places(document, part):
    stands = []
    for each in part.occurrences:
        matrix = document.getObject(each.root).getSubObject(each.path, retType=4)
        stands.append(np.array(matrix.A).reshape(4, 4))
    return np.array([each @ np.linalg.inv(stands[0]) for each in stands])
