# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flow: part -> surface mesh -> descriptors -> classification -> part record."""

import sys
import time
import traceback
from dataclasses import replace

from ...core.analysis_settings import MOST_TRIANGLES, PAIRS
from ...core.descriptors.descriptor_table import body_thickness
from ...core.descriptors.wall_kinds import TAPERED
from ...core.errors import MeshError, ThinPartError
from ...core.figures import Length
from ...core.judging.classification import classify
from ...core.judging.criteria import PAPER, load_profile
from ...core.mesh.mass_properties import area, volume
from ...core.mesh.resolution import Resolution, error_to_judge_with, is_turned_too_far, smallest_side
from ...core.message import message
from ...core.problem import problem_of
from ...core.record.part_record import part_record
from ...core.record.record_types import SecondsRecord
from ...core.risk.mesh_risk import judged_risk
from ...core.sizing.mesh_hazards import mesh_hazards
from ...core.thickness.measured_precision import chords_of, precision_of
from ...core.thickness.measurement import measure
from ...core.walls.face_thickness import face_thicknesses, witness_of
from ...core.walls.near_faces import near_faces
from ...core.walls.thin_places import LEAST
from ...core.walls.thinnest_place import MOST_TRIED, WallErrors
from ...core.walls.thinnest_wall import touching_sample
from ...system.exit_cause import is_out_of_memory

PLACED = 0.01
"""Share by which a place that was found in the geometry itself may be thicker than the thinnest one near by."""

DOUBTFUL = 4.0
"""Error bounds within which a wall that the geometry does not confirm is taken for an artefact of facets."""


def analyse_part(part, settings, profile, report=None):
    """Analyse one part; raises ThinPartError. Returns Measurement, PartRecord.

    Parameters
    ----------
    part : SolidPart or MeshedPart
    settings : AnalysisSettings
    profile : Profile
    report : callable, optional
        Called with a stage and its completed fraction; may raise `Cancelled` to stop.
    """
    seconds: SecondsRecord = {"read": 0.0, "tessellate": 0.0, "measure": 0.0}
    meshes: dict = {}
    paper = load_profile(PAPER)

    def is_near_enough(known):
        return all(each.is_certain_of_wall_distances(known) for each in (profile, paper))

    while True:
        mesh, resolution, error_bound, measurement, warnings = _measure(
            part, settings, meshes, seconds, report, is_near_enough)
        classification = classify(measurement.descriptors, profile)
        finer = None if classification.is_certain else _finer_settings(part, settings, measurement, profile)
        if finer is None:
            break
        settings = finer
    measurement = _confirmed(part, measurement, resolution.error)
    measurement, errors = _with_confirmed_place(part, measurement, resolution, error_bound)
    classification = classify(measurement.descriptors, profile)
    paper_classification = classify(measurement.descriptors, paper)
    diagonal = measurement.descriptors.box.diagonal
    thin_limit_mm = classification.thin_limit_x * diagonal
    faces = face_thicknesses(measurement.field, thin_limit_mm, measurement.thinnest_wall, measurement.places,
                             measurement.thinnest)
    record = part_record(
        part, mesh, measurement, classification, paper_classification, faces, errors, resolution.deflection,
        judged_risk(measurement.descriptors)
    )
    record["warnings"] += warnings + _plausibility_warnings(part, mesh, measurement.field, diagonal)
    record["seconds"] = seconds
    return measurement, record


def analyse_parts(parts, settings, profile, read_seconds=0.0, report=None, on_result=None):
    """Analyse the parts of one document; if one fails, the others are still analysed.

    Returns `records` (list of PartRecord) and `failures` (list of FailureRecord). Raises Cancelled: from `report`.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
    settings : AnalysisSettings
    profile : Profile
    read_seconds : float, optional
        Seconds that reading all of them took.
    report : callable, optional
        Called with a stage and the completed fraction of all parts; may raise `Cancelled` to stop.
    on_result : callable, optional
        Called with every part, its `Measurement` and its record.
    """
    records, failures = [], []
    for number, part in enumerate(parts):
        def part_report(stage, fraction, number=number):
            report(stage, (number + fraction) / len(parts))

        try:
            measurement, record = analyse_part(part, settings, profile, report and part_report)
            if on_result is not None:
                on_result(part, measurement, record)
        except ThinPartError as error:
            failures.append({"part": part.name, "label": part.label, "kind": error.kind,
                             "message": message("{about}: {sentence}", about=part.label, sentence=error)})
            continue
        except Exception as error:  # of any kind: the other parts of the file still have their verdicts
            if is_out_of_memory(error):
                raise
            traceback.print_exc(file=sys.stderr)
            failures.append({"part": part.name, "label": part.label, "kind": "failed",
                             "message": message("{file} failed ({problem}).", file=part.label, problem=problem_of(error))})
            continue
        record["seconds"]["read"] = read_seconds / len(parts)
        record["seconds"] = {key: round(value, 4) for key, value in record["seconds"].items()}
        records.append(record)
    return records, failures


def _finer_settings(part, settings, measurement, profile):
    """The settings to try next where the verdict is within the error of what was measured.

    None where no finer ones are expected to decide it: a value that stays within its error at the finest is borderline.
    """
    if settings.measure == PAIRS:
        return None
    finer = settings.finer
    while finer is not None:
        more_samples = replace(
            finer, linear_deflection=settings.linear_deflection, angular_deflection=settings.angular_deflection)
        known, turned = measurement.descriptors, finer.angular_deflection / settings.angular_deflection
        if _would_decide(known, known.precision.at(finer.minimum_samples), profile):
            return more_samples
        expected = measurement.field.mesh.count / turned ** 2
        if part.can_be_finer and expected <= MOST_TRIANGLES \
                and _would_decide(known, known.precision.at(finer.minimum_samples, turned), profile):
            return finer
        finer = finer.finer
    return None


def _would_decide(known, precision, profile):
    """Whether values that were measured with a precision would decide, were they the same."""
    return classify(replace(known, precision=precision), profile).is_certain


def _measure(part, settings, meshes, seconds, report, is_near_enough):
    """Tessellate and measure, with finer meshes as long as the chord error is too large for the part.

    Adds to `seconds`, and keeps in `meshes` what was tessellated, by linear and angular deflection.
    """
    linear = settings.linear_deflection
    while True:
        started = time.perf_counter()
        if report is not None:
            report("tessellate", 0.0)
        fineness = linear, settings.angular_deflection
        if fineness not in meshes:
            meshes[fineness] = part.surface_mesh(settings, linear)
        mesh, deflections = meshes[fineness]
        resolution = Resolution(float(deflections.max()), mesh.extent, mesh.rounding, settings.wall_deflection)
        # If the mesh is too coarse for the body itself, such as a thin rod, measuring walls is pointless.
        body = body_thickness(_volume(mesh), area(mesh))
        unresolved = None if resolution.is_enough_for(body) else body
        finer = _finer_deflection(part, settings, mesh, deflections, resolution, linear, body, unresolved)
        tessellated = time.perf_counter()
        seconds["tessellate"] += tessellated - started
        if finer is not None:
            linear = finer
            continue
        measurement, finer = _measured(part, settings, mesh, deflections, resolution, linear, report, is_near_enough)
        seconds["measure"] += time.perf_counter() - tessellated
        if finer is None:
            break
        linear = finer
    side, wall = smallest_side(measurement.descriptors), _parallel_mm(measurement)
    walls = measurement.thin_samples[:1]
    wall_error = float(resolution.wall_error(chords_of(measurement.field, walls, deflections)).max(initial=0.0))
    error = error_to_judge_with([(side, resolution.error), (wall, wall_error)])
    precision = precision_of(measurement, deflections, settings.accuracy)
    measurement = replace(measurement, descriptors=replace(
        measurement.descriptors, length_error=error, precision=precision, hazards=_hazards(part, measurement)))
    is_enough = resolution.is_enough_for(side) and resolution.is_enough_for(wall, wall_error)
    warnings = [] if is_enough else [_resolution_warning(measurement, resolution, wall_error)]
    return mesh, resolution, wall_error if len(walls) else resolution.error, measurement, warnings


def _hazards(part, measurement):
    """What makes a part hard to mesh, HazardsRecord; None for triangles without faces."""
    if part.edge_lengths is None:
        return None
    local, box = measurement.descriptors.local, measurement.descriptors.box
    thin = None if local is None else local.quantiles["T05"] * float(box.dimensions[1])
    return mesh_hazards(measurement.field, box.diagonal, part.edge_lengths, thin)


def _measured(part, settings, mesh, deflections, resolution, linear, report, is_near_enough):
    """The measurement, and the linear deflection that it asks for: one of them is None."""
    finer = None

    def is_fine_enough(known, field, walls):
        nonlocal finer
        # A wall is as certain as the facets at its two ends. Others may be coarser: it is not refined for them.
        side, thickness = smallest_side(known), field.distance[walls]
        blurred = thickness[~resolution.is_enough_for(thickness, chords_of(field, walls, deflections))]
        unresolved = [*blurred, *([] if resolution.is_enough_for(side) else [side])]
        smallest = min([*thickness, *([] if side is None else [side])], default=None)
        finer = _finer_deflection(
            part, settings, mesh, deflections, resolution, linear, smallest, min(unresolved, default=None))
        return finer is None

    measurement = measure(
        mesh, settings, report and (lambda done: report("measure", done)), is_fine_enough, is_near_enough)
    return measurement, finer


def _confirmed(part, measurement, error):
    """The measurement with its thinnest wall taken from the part's own geometry.

    A wall that the geometry does not have, because facets came too close to each other, gives way to the next. One that is
    thicker than facets may be off stays as the rays found it: there are surfaces that OCC cannot cut. One whose sides are
    not quite parallel, as where an edge begins to be rounded, gives way to the next too.
    """
    first = None
    for sample in measurement.thin_samples[:MOST_TRIED]:
        found = witness_of(measurement.field, sample)
        wall = part.exact_wall(found, error) or (found if found.distance > DOUBTFUL * error else None)
        if wall is None:
            continue
        first = first or wall
        if not part.rounds_off(wall, measurement.places.depth):
            return measurement.with_thinnest_wall(wall)
    return measurement if first is None else measurement.with_thinnest_wall(first)


def _with_confirmed_place(part, measurement, resolution, error_bound):
    """Take the thinnest place of a measurement from the part's own geometry.

    Returns it and its WallErrors.
    """
    places = measurement.places

    def confirmed(wall, kind, step, width, least):
        place = part.exact_place(wall, resolution.error, kind, places.depth, step, least)
        if not place.is_wall:
            return None, kind
        is_known = kind is not None and wall.distance > DOUBTFUL * resolution.error
        found, kind = place.wall or (wall if is_known else None), place.kind or kind
        is_asked = kind == TAPERED and found is not None and found.distance < least
        return None if is_asked and not part.is_more_than_an_edge(found, places.depth, width >= 1.0) else found, kind

    def near(below):
        return near_faces(measurement.field.mesh, below, LEAST * places.depth)

    measurement = measurement.with_thinnest_place(confirmed, near if part.can_be_finer else None)
    placed = measurement.thinnest
    if placed is None:
        return measurement, WallErrors(error_bound, error_bound, error_bound)

    def error_of(wall):
        if wall is None or wall is measurement.thinnest_wall:
            return error_bound
        return PLACED * wall.distance if part.can_be_finer else resolution.error

    return measurement, WallErrors(error_bound, error_of(placed.witness), error_of(placed.wall))


def _parallel_mm(measurement):
    """Thickness of the thinnest parallel wall, mm or None: the one that a mesh has to resolve."""
    return None if measurement.thinnest_wall is None else measurement.thinnest_wall.distance


def _finer_deflection(part, settings, mesh, deflections, resolution, linear, smallest, unresolved):
    """The next linear deflection as a share of the diagonal; None where none is needed, or none would be enough.

    `smallest` and `unresolved` are lengths, mm or None: the smallest of the part, and the smallest that the mesh blurs.
    """
    length = smallest if unresolved is None else unresolved
    if not part.can_be_finer or length is None:
        return None
    if unresolved is None and not is_turned_too_far(mesh, settings.angular_deflection):
        return None
    finest = part.finest_deflection(settings, resolution.required_deflection(length), mesh, deflections)
    return finest if finest is not None and finest < linear else None


def _volume(mesh):
    """Volume of a mesh, mm3; None if a coarse mesh encloses none: a finer one may do so."""
    try:
        return volume(mesh)
    except MeshError:
        return None


def _resolution_warning(measurement, resolution, wall_error):
    """A warning that the mesh limits the accuracy of the result: str."""
    wall = _parallel_mm(measurement)
    if resolution.is_enough_for(wall, wall_error):
        return message("The part is slender: its lengths are accurate to {error:.2g} only, a finer mesh would be "
                       "too large.", error=Length(resolution.error))
    if wall < wall_error:
        return message("The thinnest wall, {wall}, is below what the mesh resolves ({error:.2g}).",
                       wall=Length(wall), error=Length(wall_error))
    return message("The thinnest wall is {wall} ± {error:.2g}: a finer mesh would be too large.",
                   wall=Length(wall), error=Length(wall_error))


def _plausibility_warnings(part, mesh, field, diagonal):
    """Warnings about parts that can be measured but are probably not as intended."""
    warnings = []
    if len(field.entered) and mesh.watertight:
        warnings.append(
            message("The surface intersects itself, for example below ({place}): repair it, its thickness and volume "
                    "are not certain.", place=_place(field.points(field.entered[0])[0]))
        )
    touching = touching_sample(field)
    if touching is not None:
        warnings.append(message(
            "Surfaces touch or cross at ({place}): what lies between them is not counted as a wall.",
            place=_place(field.points(touching)[0])))
    missing = part.missing_faces(mesh)
    first_faces = ", ".join(missing[:5])
    if len(missing) > 5:
        warnings.append(message("FreeCAD could not tessellate {faces} and {count} more.",
                                faces=first_faces, count=len(missing) - 5))
    elif missing:
        warnings.append(message("FreeCAD could not tessellate {faces}.", faces=first_faces))
    if diagonal < 0.1 or diagonal > 1e5:
        warnings.append(
            message("The part is {mm} across: check that the file's unit is millimetres.", mm=Length(diagonal))
        )
    return warnings


def _place(point):
    """Coordinates, mm, as FreeCAD shows them: Message."""
    x, y, z = (round(float(each), 4) + 0.0 for each in point)  # not 1e-08, nor -0
    return message("{x:.3g}, {y:.3g}, {z:.3g}", x=x, y=y, z=z)
