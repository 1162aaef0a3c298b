"""Part records as types, for people who write programs with them and for their editors.

`part_definition` defines records; tests compare these types with it. At run time a record is a plain dict. Classes
whose names begin with an underscore have the required keys; the classes derived from them add the optional ones.
"""

from typing import Any, Optional, TypedDict, Union

Criterion = Union[int, str]
"""Id of a criterion."""

ProfileContent = dict[str, Any]
"""A profile as its JSON file has it; see resources/profiles/paper.json."""


class WitnessRecord(TypedDict):
    """Where a wall was measured: from a point of one face to one of another, mm."""

    distance: float
    points: list[list[float]]
    opposite_face: str


class FaceRecord(TypedDict):
    """The walls under one face. Lengths in mm over parallel walls, None where there are none."""

    face: str
    area_mm2: float
    min: Optional[float]
    median: Optional[float]
    max: Optional[float]
    thin_share: float
    unmeasured_share: float
    witness: Optional[WitnessRecord]
    wedge: Optional[WitnessRecord]


class _RegionRecord(TypedDict):
    kind: str
    area_mm2: float
    min: float
    median: float
    length_mm: float
    width_mm: float
    volume_share: Optional[float]
    place: list[float]
    faces: list[str]


class RegionRecord(_RegionRecord, total=False):
    """A connected wall: kind, area of both sides, thickness, length, developed width, a point of it, its faces, and where it
    is thinnest."""

    witness: Optional[WitnessRecord]


class RegionsRecord(TypedDict):
    """Connected walls, the thinnest first; and how many smaller ones are left out, and their share of the area."""

    listed: list[RegionRecord]
    others: int
    others_share: float


class _ConditionRow(TypedDict):

    quantity: str
    value: Optional[float]
    comparison: str
    threshold: float
    holds: Optional[bool]
    margin: Optional[float]


class ConditionRow(_ConditionRow, total=False):
    """A condition of a criterion and its result; ``holds`` is None where it is undecided."""

    error: Optional[float]


class EvidenceRow(TypedDict):
    """A criterion of the profile, its conditions, and whether all of them hold."""

    criterion: Criterion
    category: str
    title: str
    holds: Optional[bool]
    margin: Optional[float]
    conditions: list[ConditionRow]


class VerdictRecord(TypedDict):
    """The verdict of a profile on a part: the first keys of its record."""

    category: str
    criteria: list[Criterion]
    margin: Optional[float]
    borderline: bool


class CategoryProbability(TypedDict):
    """How probable a category is."""

    category: str
    probability: float


class PaperVerdict(TypedDict):
    """The verdict of the paper's own thresholds, whatever the profile."""

    category: str
    criteria: list[Criterion]


class ThicknessRecord(TypedDict):
    """Thickness of parallel walls, mm, the median by area; and its error bound."""

    min: Optional[float]
    median: Optional[float]
    max: Optional[float]
    error_bound: float


class SharesRecord(TypedDict):
    """Shares of the area: over parallel walls, over non-parallel walls, unmeasured, and where rays hit nothing."""

    parallel: float
    nonparallel: float
    unmeasured: float
    unmet: float


class DistributionRecord(TypedDict):
    """Area by thickness: bin k covers x in [k/1000, (k+1)/1000)."""

    bins: list[int]
    area: list[float]


class MiddleRecord(TypedDict):
    """Shares of the surface by thickness in units of the middle side of the box."""

    bins: list[int]
    parallel: list[float]
    nonparallel: list[float]


class NonparallelRecord(TypedDict):
    """Area by distance and angle of walls that are not parallel."""

    bins: list[int]
    angles: list[int]
    area: list[float]


SampledShares = TypedDict("SampledShares", {"0:0.05": float, "0:0.25": float, "0.05:0.29": float, "0.3:0.7": float})
SampledShares.__doc__ = """F[a;b] for the ranges that the paper's criteria use."""


class RegionCounts(TypedDict):
    """Median thickness of the thinnest wall region, number of all, and of each kind among those that are listed."""

    thinnest_mm: Optional[float]
    count: Optional[int]
    plate: Optional[int]
    tube: Optional[int]
    bar: Optional[int]
    block: Optional[int]
    taper: Optional[int]
    tooth: Optional[int]


class _DescriptorsRecord(TypedDict):

    volume_mm3: Optional[float]
    area_mm2: float
    box_mm: list[float]
    box_axes: list[list[float]]
    diagonal_mm: float
    volume_ratio: Optional[float]
    d1_d2: Optional[float]
    d2_d3: Optional[float]
    F: SampledShares
    teeth: int
    min_nonparallel: Optional[float]
    thickness_mm: ThicknessRecord
    shares: SharesRecord
    distribution: DistributionRecord
    nonparallel: NonparallelRecord
    watertight: bool


class QuantityError(TypedDict):
    """How far a quantity may be off; None where that is not known."""

    quantity: str
    error: Optional[float]


class PrecisionRecord(TypedDict):
    """How precisely a part was measured."""

    accuracy: str
    samples: int
    wall_mm: float
    chord_mm: float
    mean_chord_mm: float
    area_share: float
    plate_share: float
    errors: list[QuantityError]


class DescriptorsRecord(_DescriptorsRecord, total=False):
    """What was measured on a part; docs/info-file.md explains the keys."""

    precision: Optional[PrecisionRecord]
    middle: Optional[MiddleRecord]
    plate_share: Optional[float]
    regions: RegionCounts


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

    person: str
    category: str
    sure: bool
    when: str


class _RegionNote(TypedDict):
    place: list[float]
    faces: list[str]
    person: str
    when: str


class MeshedWall(TypedDict):
    """A wall as it was meshed; without a size where it was left out."""

    kind: str
    thickness_mm: float
    size_mm: Optional[float]
    is_changed: bool


class MeshedRecord(TypedDict):
    """Mesh settings that worked for a part, and what Gmsh made with them."""

    when: str
    version: str
    order: int
    layers: Optional[float]
    growth: float
    size_mm: Optional[float]
    budget: Optional[int]
    global_size_mm: float
    diagonal_mm: float
    walls: list[MeshedWall]
    elements: int
    poor_share: Optional[float]
    gamma_least: Optional[float]
    layers_share: Optional[float]
    how: str


class RegionNote(_RegionNote, total=False):
    """What a person said of a wall region: why it is left out, and the element size that is wanted there."""

    excluded: str
    mesh_size_mm: float


class _PartRecord(VerdictRecord):
    name: str
    label: str
    instances: int
    reason: str
    evidence: list[EvidenceRow]
    paper: PaperVerdict
    descriptors: DescriptorsRecord
    thin_limit_mm: float
    faces: list[FaceRecord]
    notes: str
    warnings: list[str]
    triangles: int
    samples: int
    deflection_mm: float
    seconds: SecondsRecord


class PartRecord(_PartRecord, total=False):
    """All that is known about a part."""

    probabilities: list[CategoryProbability]
    mesh: MeshAnnotation
    link: str
    labels: list[PersonLabel]
    region_notes: list[RegionNote]
    meshed: MeshedRecord
    regions: RegionsRecord


class _FailureRecord(TypedDict):
    part: Optional[str]
    kind: str
    message: str


class FailureRecord(_FailureRecord, total=False):
    """A part, or with ``part`` None a document, that could not be analysed."""

    label: Optional[str]
