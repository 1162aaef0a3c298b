# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one definition of part records, profiles and failures: types with the limits of their values.

Programs and editors know records by them; checks of info files and the JSON schema are derived (`typed_kinds`). At run time
a record is a plain dict. Lengths are in mm; docs/info-file.md says what each key means.
"""

from typing import Annotated, Any, Optional, TypedDict, Union

from ..analysis_settings import ACCURACIES, BOXES, MEASURES
from ..descriptors.descriptor_types import Share
from ..descriptors.recorded_descriptors import DESCRIPTORS, DescriptorsRecord
from ..descriptors.region_kinds import REGION_KINDS
from ..descriptors.wall_kinds import WALL_KINDS
from ..forms.face_surfaces import SURFACES
from ..kinds.compound_kinds import Known
from ..kinds.key_presence import NotRequired
from ..kinds.typed_kinds import LATER, Restricted, kind_of
from ..kinds.value_kinds import LARGEST_WHOLE, Number, OneOf, Text, Whole

Criterion = Union[Annotated[int, Whole(-LARGEST_WHOLE)], str]
"""Id of a criterion."""

Point = Annotated[list[float], Restricted(least=3, most=3)]
"""mm"""

RegionKind = Annotated[str, OneOf(REGION_KINDS)]

Time = Annotated[str, Text(
    40, r"[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}(\.[0-9]+)?(Z|[+-][0-9]{2}:[0-9]{2})", "a date and time")]

Person = Annotated[str, Text(200, r"[^\x00\n]*[^\x00\s][^\x00\n]*", "a name in one line")]
"""Name of a person who labels parts."""

_ElementSize = Annotated[float, Number(1e-9, 1e9)]
_ElementShare = Annotated[float, Number(0.0, 1.0 + 1e-9)]


class WitnessRecord(TypedDict):
    """Where a wall was measured: from a point of one face to one of another."""

    distance: float
    points: Annotated[list[Point], Restricted(least=2, most=2)]
    opposite_face: str


class FaceRecord(TypedDict):
    """The walls under one face, None where there are none: the thinnest; median and greatest of parallel ones, or of tapered
    ones where none is parallel. On which kind of surface it lies, with the radius where it has one; None for a patch of
    triangles. The first face that is equal to it; None where it is the first. And the median of the largest
    balls inside that reach it, or of the thickness across where that is less."""

    face: str
    area_mm2: float
    min: Optional[float]
    median: Optional[float]
    max: Optional[float]
    thin_share: Share
    unmeasured_share: Share
    witness: Optional[WitnessRecord]
    wedge: Optional[WitnessRecord]
    surface: NotRequired[Annotated[Optional[Annotated[str, OneOf(SURFACES)]], LATER]]
    radius_mm: NotRequired[Annotated[Optional[float], LATER]]
    equal_to: NotRequired[Annotated[Optional[str], LATER]]
    ball_mm: NotRequired[Annotated[Optional[Annotated[float, Number(0.0)]], LATER]]


class ThinnestRecord(TypedDict):
    """Where the part is thinnest, mm: between parallel sides, in a taper, or at a depth beside a sharp edge; the thinnest
    wall apart from sharp edges and the thinnest parallel one, with their errors; the length of all sharp edges; and how many
    places are thinner than a length."""

    kind: Annotated[str, OneOf(WALL_KINDS)]
    face: str
    witness: WitnessRecord
    walls_mm: Optional[Annotated[float, Number(0.0)]]
    walls_error_mm: Annotated[float, Number(0.0)]
    parallel_mm: Optional[Annotated[float, Number(0.0)]]
    parallel_error_mm: Annotated[float, Number(0.0)]
    depth_mm: Annotated[float, Number(0.0)]
    edges_mm: Annotated[float, Number(0.0)]
    places: Annotated[int, Whole(1)]
    below_mm: Annotated[float, Number(0.0)]


class RegionRecord(TypedDict):
    """A connected wall: kind, area of both sides, thickness, length, developed width, a point of it, its faces, and where it
    is thinnest."""

    kind: RegionKind
    area_mm2: float
    min: float
    median: float
    length_mm: float
    width_mm: float
    volume_share: Optional[Share]
    place: Point
    faces: list[str]
    witness: NotRequired[Annotated[Optional[WitnessRecord], LATER]]


class RegionsRecord(TypedDict):
    """Connected walls, the thinnest first; and how many smaller ones are left out, and their share of the area."""

    listed: list[RegionRecord]
    others: int
    others_share: Share


class FormRecord(TypedDict):
    """The form of the part, by which it is compared with others: centroid, moments of the surface about it, points of the
    surface with normals, packed, and a hash of how faces of which kinds lie beside each other, None for triangles."""

    centroid: Point
    second_mm2: Annotated[list[float], Restricted(least=6, most=6)]
    third_mm3: Annotated[list[float], Restricted(least=10, most=10)]
    points: Annotated[int, Whole(1)]
    reach_mm: Annotated[float, Number(0.0)]
    topology: Optional[Annotated[str, Text(16, r"[0-9a-f]{16}", "a hash")]]
    outline: Annotated[str, Text(1_000_000, r"[A-Za-z0-9+/]*={0,2}", "bytes in base64")]


class ConditionRow(TypedDict):
    """A condition of a criterion and its result; ``holds`` is None where it is undecided."""

    quantity: str
    value: Optional[float]
    comparison: Annotated[str, OneOf(("<", ">"))]
    threshold: float
    holds: Optional[bool]
    margin: Optional[float]
    error: NotRequired[Annotated[Optional[float], LATER]]


class EvidenceRow(TypedDict):
    """A criterion of the profile, its conditions, and whether all of them hold."""

    criterion: Criterion
    category: str
    title: str
    holds: Optional[bool]
    margin: Optional[float]
    conditions: Annotated[list[ConditionRow], Restricted(least=1)]


class PaperVerdict(TypedDict):
    """The verdict of the paper's own thresholds, whatever the profile."""

    category: str
    criteria: list[Criterion]


class VerdictRecord(TypedDict):
    """The verdict of a profile on a part, and whether it is unsure."""

    category: str
    criteria: list[Criterion]
    margin: Optional[float]
    borderline: bool


class CategoryProbability(TypedDict):
    """How probable a category is."""

    category: str
    probability: Share


class RiskReason(TypedDict):
    """A quantity that raises the risk of the automatic mesh, its value, and what it adds to the logarithm of the odds."""

    quantity: str
    value: float
    raises: float


class MeshRiskRecord(TypedDict):
    """How probable it is that the automatic mesh of a part goes wrong, None if unknown; and why, the most first."""

    risk: Optional[Share]
    reasons: Annotated[list[RiskReason], Restricted(most=100)]


class SecondsRecord(TypedDict):
    """Time spent on a part, seconds."""

    read: float
    tessellate: float
    measure: float


class MeshAnnotation(TypedDict, total=False):
    """Mesh settings that are stored with a part, or the name of a file that holds them."""

    settings: dict[str, Any]
    file: str


class PersonLabel(TypedDict):
    """The category that a part has in the eyes of a person, and when that was said."""

    person: Person
    category: Annotated[str, Text(200, r"[^\x00]*\S[^\x00]*", "a category")]
    sure: bool
    when: Time


class RegionNote(TypedDict):
    """What a person said of a wall region: why it is left out, and the element size that is wanted there."""

    place: Point
    faces: list[str]
    person: Person
    when: Time
    excluded: NotRequired[Annotated[str, Text(
        2000, r"[^\x00]*[^\x00\s][^\x00]*", "a reason",
        about="why people leave the region out; verdict and criteria do not")]]
    mesh_size_mm: NotRequired[Annotated[_ElementSize, Restricted(about="element size that is wanted there")]]


class FaceLimit(TypedDict):
    """Limits of the wall for one face, with its area and kind of surface, by which it is found again; who says so, why."""

    face: str
    area_mm2: Annotated[float, Number(0.0)]
    surface: Optional[Annotated[str, OneOf(SURFACES)]]
    person: Person
    when: Time
    reason: Annotated[str, Text(2000, r"[^\x00]*[^\x00\s][^\x00]*", "a reason")]
    min_mm: NotRequired[Annotated[_ElementSize, Restricted(about="the least wall that the face may have")]]
    max_mm: NotRequired[Annotated[_ElementSize, Restricted(about="the greatest wall that the face may have")]]


class MeshedWall(TypedDict):
    """A wall as it was meshed; without a size where it was left out."""

    kind: RegionKind
    thickness_mm: Annotated[float, Number(0.0)]
    size_mm: Optional[_ElementSize]
    is_changed: bool


class MeshedRecord(TypedDict):
    """Mesh settings that worked for a part, and what Gmsh made with them."""

    when: Time
    version: Annotated[str, Text(200, about="of ThinPart")]
    order: Annotated[int, OneOf((1, 2))]
    error: NotRequired[Annotated[Optional[Annotated[float, Number(0.0, 1.0)]], LATER]]
    layers: Optional[Annotated[float, Number(0.1, 20.0)]]
    growth: Annotated[float, Number(1.05, 3.0)]
    size_mm: Optional[Annotated[_ElementSize, Restricted(about="greatest element size; null for a tenth of the diagonal")]]
    budget: Optional[Annotated[int, Whole(1)]]
    global_size_mm: Annotated[float, Number(0.0)]
    diagonal_mm: Annotated[float, Number(1e-9, 1e12)]
    walls: Annotated[list[MeshedWall], Restricted(
        most=10_000, about="size null for a wall that was left out; whether people chose it")]
    elements: Annotated[int, Whole(1)]
    poor_share: Optional[_ElementShare]
    gamma_least: Optional[float]
    layers_share: Optional[_ElementShare]
    how: Annotated[str, Text(2000, about="which try gave the mesh")]


Notes = Annotated[str, Restricted(about="what people wrote about the part")]


class Annotations(TypedDict, total=False):
    """What users store with a part, beside its notes."""

    mesh: Annotated[MeshAnnotation, Restricted(
        choice=("settings", "file"),
        about="mesh settings that proved right for the part, or the name of a file that holds them")]
    link: Annotated[str, Restricted(about="an address or file name that belongs to the part")]
    labels: Annotated[list[PersonLabel], Restricted(
        most=1000, distinct="person", about="the category that the part has in the eyes of people, one answer each")]
    region_notes: Annotated[list[RegionNote], Restricted(
        most=10_000, about="what people said of wall regions, which are found again by place and faces")]
    face_limits: Annotated[list[FaceLimit], Restricted(
        most=10_000, distinct="face", about="limits of the wall for single faces, which checks respect")]
    meshed: Annotated[MeshedRecord, Restricted(about="mesh settings that worked, and what Gmsh made with them")]


class _NamedPart(TypedDict):
    name: str
    label: str
    instances: Annotated[int, Whole(1)]


class _Judged(_NamedPart, VerdictRecord):
    reason: str
    evidence: list[EvidenceRow]
    paper: PaperVerdict
    descriptors: Annotated[DescriptorsRecord, DESCRIPTORS]
    thin_limit_mm: float
    faces: list[FaceRecord]
    notes: Notes
    warnings: list[str]
    triangles: int
    samples: int
    deflection_mm: float
    seconds: SecondsRecord
    probabilities: NotRequired[Annotated[list[CategoryProbability], Restricted(
        about="of every category, the most probable first, where the profile has a model of them")]]


class PartRecord(_Judged, Annotations):
    """All that is known about a part."""

    thinnest: NotRequired[Annotated[Optional[Annotated[ThinnestRecord, Restricted(
        about="where the part is thinnest, over walls at any angle")]], LATER]]
    regions: NotRequired[Annotated[RegionsRecord, Restricted(
        about="connected walls of like thickness, the thinnest first"), LATER]]
    form: NotRequired[Annotated[FormRecord, Restricted(
        about="moments of the surface, and points of it with normals, by which parts are compared"), LATER]]
    mesh_risk: NotRequired[Annotated[MeshRiskRecord, Restricted(
        about="how probable it is that a mesh of a tenth of the diagonal goes wrong, and why"), LATER]]


class FailureRecord(TypedDict):
    """A part, or with ``part`` None a document, that could not be analysed."""

    part: Optional[str]
    kind: str
    message: str
    label: NotRequired[Annotated[Optional[str], LATER]]


class SettingsRecord(TypedDict):
    """The settings that affect a result; see `AnalysisSettings`."""

    linear_deflection: float
    angular_deflection: float
    wall_deflection: float
    measure: Annotated[str, OneOf(MEASURES)]
    box: Annotated[str, OneOf(BOXES)]
    minimum_samples: int
    accuracy: NotRequired[Annotated[str, OneOf(tuple(ACCURACIES)), LATER]]


class _NamedEntry(TypedDict):
    name: str
    title: NotRequired[str]


class _ProfileHead(TypedDict):
    format: str
    version: int
    name: str
    title: NotRequired[str]
    categories: Annotated[list[Annotated[_NamedEntry, Restricted(is_open=True)]], Restricted(most=1000)]


PROFILE = Known(kind_of(Annotated[_ProfileHead, Restricted(is_open=True)]))
"""Kind of a profile, as far as code that does not classify needs it; `criteria` validates the rest."""

ProfileContent = Annotated[dict[str, Any], PROFILE]
"""A profile as its JSON file has it; see resources/profiles/paper.json."""

PART, FAILURE, PERSON = kind_of(PartRecord), kind_of(FailureRecord), kind_of(Person)
"""Kinds of a part record, of a failure and of the name of a person."""
