"""Definitions of part records, profiles and failures, by which info files are validated.

Lengths are in mm. See docs/info-file.md for what each key means.
"""

from ..analysis_settings import ACCURACIES, BOXES, MEASURES
from ..descriptors.recorded_descriptors import DESCRIPTORS
from ..descriptors.region_kinds import REGION_KINDS
from ..kinds.compound_kinds import Known, ListOf, Record
from ..kinds.value_kinds import LARGEST_WHOLE, Either, Flag, Number, OneOf, OrNull, Text, Whole

_TEXT, _FLAG, _COUNT, _NUMBER, _SHARE = Text(), Flag(), Whole(), Number(), Number(0, 1)
_MAYBE_NUMBER, _MAYBE_FLAG = OrNull(_NUMBER), OrNull(_FLAG)
_CRITERION = Either(Whole(-LARGEST_WHOLE), _TEXT)
_CRITERIA = ListOf(_CRITERION)
_POINT = ListOf(_NUMBER, 3, 3)

_WITNESS = OrNull(Record({
    "distance": _NUMBER,
    "points": ListOf(_POINT, 2, 2),
    "opposite_face": _TEXT,
}))

_FACE = Record({
    "face": _TEXT,
    "area_mm2": _NUMBER,
    "min": _MAYBE_NUMBER,
    "median": _MAYBE_NUMBER,
    "max": _MAYBE_NUMBER,
    "thin_share": _SHARE,
    "unmeasured_share": _SHARE,
    "witness": _WITNESS,
    "wedge": _WITNESS,
})

_REGIONS = Record({
    "listed": ListOf(Record({
        "kind": OneOf(REGION_KINDS),
        "area_mm2": _NUMBER,
        "min": _NUMBER,
        "median": _NUMBER,
        "length_mm": _NUMBER,
        "width_mm": _NUMBER,
        "volume_share": OrNull(_SHARE),
        "place": _POINT,
        "faces": ListOf(_TEXT),
    }, later={"witness": _WITNESS})),
    "others": _COUNT,
    "others_share": _SHARE,
}, about="connected walls of like thickness, the thinnest first")

_EVIDENCE = Record({
    "criterion": _CRITERION,
    "category": _TEXT,
    "title": _TEXT,
    "holds": _MAYBE_FLAG,
    "margin": _MAYBE_NUMBER,
    "conditions": ListOf(Record({
        "quantity": _TEXT,
        "value": _MAYBE_NUMBER,
        "comparison": OneOf(("<", ">")),
        "threshold": _NUMBER,
        "holds": _MAYBE_FLAG,
        "margin": _MAYBE_NUMBER,
    }, later={"error": _MAYBE_NUMBER}), least=1),
})

TIME = Text(40, r"[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}(\.[0-9]+)?(Z|[+-][0-9]{2}:[0-9]{2})",
            "a date and time")
"""Kind of a date and time."""

PERSON = Text(200, r"[^\x00\n]*[^\x00\s][^\x00\n]*", "a name in one line")
"""Kind of the name of a person who labels parts."""

ANNOTATIONS = {
    "notes": Text(about="what people wrote about the part"),
    "mesh": Record(
        {}, {"settings": Record({}, is_open=True), "file": _TEXT}, choice=("settings", "file"),
        about="mesh settings that proved right for the part, or the name of a file that holds them"),
    "link": Text(about="an address or file name that belongs to the part"),
    "labels": ListOf(Record({
        "person": PERSON,
        "category": Text(200, r"[^\x00]*\S[^\x00]*", "a category"),
        "sure": _FLAG,
        "when": TIME,
    }), most=1000, distinct="person", about="the category that the part has in the eyes of people, one answer each"),
    "meshed": Record({
        "when": TIME,
        "version": Text(200, about="of ThinPart"),
        "order": OneOf((1, 2)),
        "layers": OrNull(Number(0.1, 20.0)),
        "growth": Number(1.05, 3.0),
        "size_mm": OrNull(Number(1e-9, 1e9, about="greatest element size; null for a tenth of the diagonal")),
        "budget": OrNull(Whole(1)),
        "global_size_mm": Number(0.0),
        "diagonal_mm": Number(1e-9, 1e12),
        "walls": ListOf(Record({
            "kind": OneOf(REGION_KINDS),
            "thickness_mm": Number(0.0),
            "size_mm": OrNull(Number(1e-9, 1e9)),
            "is_changed": _FLAG,
        }), most=10_000, about="size null for a wall that was left out; whether people chose it"),
        "elements": Whole(1),
        "poor_share": OrNull(Number(0.0, 1.0 + 1e-9)),
        "gamma_least": OrNull(_NUMBER),
        "layers_share": OrNull(Number(0.0, 1.0 + 1e-9)),
        "how": Text(2000, about="which try gave the mesh"),
    }, about="mesh settings that worked, and what Gmsh made with them"),
    "region_notes": ListOf(Record({
        "place": _POINT,
        "faces": ListOf(_TEXT),
        "person": PERSON,
        "when": TIME,
    }, {
        "excluded": Text(2000, r"[^\x00]*[^\x00\s][^\x00]*", "a reason",
                         about="why people leave the region out; verdict and criteria do not"),
        "mesh_size_mm": Number(1e-9, 1e9, about="element size that is wanted there"),
    }), most=10_000, about="what people said of wall regions, which are found again by place and faces"),
}
"""Annotations: what users store with a part."""

PART = Record({
    "name": _TEXT,
    "label": _TEXT,
    "instances": Whole(1),
    "category": _TEXT,
    "criteria": _CRITERIA,
    "margin": _MAYBE_NUMBER,
    "borderline": _FLAG,
    "reason": _TEXT,
    "evidence": ListOf(_EVIDENCE),
    "paper": Record({"category": _TEXT, "criteria": _CRITERIA}),
    "descriptors": DESCRIPTORS,
    "thin_limit_mm": _NUMBER,
    "faces": ListOf(_FACE),
    "notes": ANNOTATIONS["notes"],
    "warnings": ListOf(_TEXT),
    "triangles": _COUNT,
    "samples": _COUNT,
    "deflection_mm": _NUMBER,
    "seconds": Record({"read": _NUMBER, "tessellate": _NUMBER, "measure": _NUMBER}),
}, {"probabilities": ListOf(Record({"category": _TEXT, "probability": _SHARE}),
                            about="of every category, the most probable first, where the profile has a model of them"),
    **{key: ANNOTATIONS[key] for key in ("mesh", "link", "labels", "region_notes", "meshed")}}, later={"regions": _REGIONS})
"""Kind of a part record."""

FAILURE = Record(
    {"part": OrNull(_TEXT), "kind": _TEXT, "message": _TEXT},
    later={"label": OrNull(_TEXT)})
"""Kind of a part that could not be analysed."""

SETTINGS = Record({
    "linear_deflection": _NUMBER,
    "angular_deflection": _NUMBER,
    "wall_deflection": _NUMBER,
    "measure": OneOf(MEASURES),
    "box": OneOf(BOXES),
    "minimum_samples": _COUNT,
}, later={"accuracy": OneOf(tuple(ACCURACIES))})
"""Kind of the settings that affect a result."""

_NAMED = Record({"name": _TEXT}, {"title": _TEXT}, is_open=True)

PROFILE = Known(Record(
    {"format": _TEXT, "version": _COUNT, "name": _TEXT, "categories": ListOf(_NAMED, most=1000)},
    {"title": _TEXT}, is_open=True))
"""Kind of a profile, as far as code that does not classify needs it; `criteria` validates the rest."""
