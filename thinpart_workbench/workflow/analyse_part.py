"""The flow: part -> surface mesh -> descriptors -> classification -> part record."""

import time

from ..core.classification import classify
from ..core.criteria import load_profile
from ..core.face_thickness import face_thicknesses
from ..core.measurement import measure
from ..core.part_record import part_record

FINEST_DEFLECTION = 1e-6
"""Share of the diagonal below which tessellation stops, thin as a wall may be."""

MOST_TRIANGLES = 400_000
"""A part is not tessellated finer once the next step would pass this."""

_ROUNDING = 2e-7
"""FreeCAD's meshes are float32: each side of a wall may lie this share of the diagonal off."""


def analyse_part(part, settings, profile, report=None, show=None):
    """Analyse one part.

    Parameters
    ----------
    part : SolidPart or MeshedPart
    settings : AnalysisSettings
    profile : Profile
    report : callable, optional
        Called with a stage and the fraction of it that is done; may raise to stop.
    show : callable, optional
        Called at the end with the `Measurement` and the record.

    Returns
    -------
    dict
        The part record.

    Raises
    ------
    ThinPartError
    """
    mesh, deflection, measurement, seconds, warnings = _measured(part, settings, report)
    classification = classify(measurement.descriptors, profile)
    paper = classify(measurement.descriptors, load_profile("paper"))
    diagonal = measurement.descriptors.box.diagonal
    faces = face_thicknesses(measurement.field, classification.thin_limit * diagonal)
    error_bound = 2.0 * (deflection + _ROUNDING * diagonal)
    record = part_record(
        part, mesh, measurement, classification, paper, faces, error_bound, deflection
    )
    record["warnings"] += warnings + _plausibility(part, mesh, measurement.field, diagonal)
    record["seconds"] = seconds
    if show is not None:
        show(measurement, record)
    return record


def _measured(part, settings, report):
    """Tessellate and measure, finer as long as the chord error is large against the walls."""
    seconds = {"tessellate": 0.0, "measure": 0.0}
    linear, warnings = settings.linear_deflection, []
    while True:
        started = time.perf_counter()
        if report is not None:
            report("tessellate", 0.0)
        mesh, deflection = part.surface_mesh(settings, linear)
        tessellated = time.perf_counter()
        seconds["tessellate"] += tessellated - started
        measurement = measure(mesh, settings, report and (lambda done: report("measure", done)))
        seconds["measure"] += time.perf_counter() - tessellated
        wall = measurement.thinnest
        if wall is None or not part.can_be_finer:
            break
        if 2.0 * deflection <= settings.wall_deflection * wall:
            break
        wanted = 0.4 * settings.wall_deflection * wall / mesh.extent
        if wanted < FINEST_DEFLECTION or wanted >= linear or _too_many(mesh, deflection, wanted):
            warnings.append(
                f"The thinnest wall, {wall:.3g} mm, is known no better than the mesh resolves "
                f"({2.0 * deflection:.2g} mm)."
            )
            break
        linear = wanted
    return mesh, deflection, measurement, seconds, warnings


def _too_many(mesh, deflection, wanted):
    """Whether a finer mesh would pass the limit, taking every face for doubly curved."""
    return mesh.count * deflection / (wanted * mesh.extent) > MOST_TRIANGLES


def _plausibility(part, mesh, field, diagonal):
    """Warnings about what can be measured but is likely not meant."""
    warnings = []
    if len(field.entered) and mesh.watertight:
        place = ", ".join(f"{value:.3g}" for value in field.points(field.entered[0])[0])
        warnings.append(
            f"The surface passes through itself, as under ({place}): repair it, its thickness and "
            "volume are not certain."
        )
    missing = part.missing_faces(mesh)
    named = ", ".join(missing[:5])
    if len(missing) > 5:
        warnings.append(f"FreeCAD could not tessellate {named} and {len(missing) - 5} more.")
    elif missing:
        warnings.append(f"FreeCAD could not tessellate {named}.")
    if diagonal < 0.1 or diagonal > 1e5:
        warnings.append(
            f"The part is {diagonal:.3g} mm across: check that the file's unit is millimetres."
        )
    return warnings
