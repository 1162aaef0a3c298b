# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of samples: what each shows, and what the profiles should say about it."""

from dataclasses import dataclass, field

from .assembly import assembly_of_three
from .castings import solid_casting, thin_walled_casting
from .normal_parts import block, tapered_plug, vee_block
from .thin_features import (
    cuboid_with_rib,
    endless_screw,
    flange,
    gear_thin_teeth,
    ribbed_block,
    spur_gear_on_hub,
    wedge,
    worm_run_out,
)
from .thin_parts import (
    bent_sheet_bracket,
    heat_sink,
    nearly_square_dish,
    pipe_bend,
    plate,
    plate_with_openings,
    shaft,
    tube,
)


@dataclass(frozen=True)
class Sample:
    """A part to make, and what the profiles should say about it.

    Attributes
    ----------
    build : callable
        From a document to its results, a list of objects.
    shows : str
    category : str
    criteria : list of int
        By the `paper` profile.
    calibrated : str
        Category by the `calibrated` profile.
    solids : int
    records : list of (str, str, list of int, str, int)
        Label, category and criteria, category by the `calibrated` profile, and instances by solid: an assembly is
        classified solid by solid.
    """

    build: object
    shows: str
    category: str
    criteria: list
    calibrated: str
    solids: int = 1
    records: list = field(default_factory=list)

    @property
    def name(self):
        """Name of its files."""
        return self.build.__name__

    def content(self):
        """dict: its entry in samples.json."""
        entry = {
            "name": self.name,
            "shows": self.shows,
            **_verdicts(self.category or None, self.criteria, self.calibrated or None),
        }
        if self.records:
            entry["solids"] = [
                {"label": label, **_verdicts(category, criteria, calibrated), "instances": instances}
                for label, category, criteria, calibrated, instances in self.records]
        return entry


def _verdicts(category, criteria, calibrated):
    return {"category": calibrated, "paper": {"category": category, "criteria": criteria}}


SAMPLES = (
    Sample(plate, "A flat plate fills its low, wide bounding box.", "thin", [1, 4, 5], "thin"),
    Sample(bent_sheet_bracket, "Bent sheet metal fills little of its bounding box.", "thin", [3, 4], "thin"),
    Sample(tube, "A thin wall need not be flat: a tube, 2 mm thick all round.", "thin", [3, 4], "thin"),
    Sample(ribbed_block,
           "One rib on a solid block, a tenth of its width: the automatic mesh has one element across it.",
           "thin_features", [5], "thin_features"),
    Sample(gear_thin_teeth, "Pointed teeth have no parallel faces: their flanks meet at a sharp angle.",
           "thin_features", [6, 7], "thin_features"),
    Sample(spur_gear_on_hub,
           "Involute teeth that narrow towards their tips: their flanks are not parallel.",
           "thin_features", [7], "thin_features"),
    Sample(heat_sink, "Most of the surface belongs to thin fins, so the part is thin as a whole.",
           "thin", [4, 5], "thin"),
    Sample(worm_run_out,
           "A thread on a solid core, that runs out to nothing: slivers for the paper.",
           "thin_features", [7], "thin_features"),
    Sample(thin_walled_casting, "A cast cover: thin walls all over, with ribs, a boss and fillets.",
           "thin", [3, 4, 7], "thin"),
    Sample(shaft,
           "A slender shaft: thin for the paper, as its diameters are small against its length, but without a thin wall.",
           "thin", [4], "normal"),
    Sample(block, "A compact block with rounded edges.", "normal", [], "normal"),
    Sample(flange, "A disc beside a thick stub: thin features of the paper, but no wall below 6 % of the width.",
           "thin_features", [6], "normal"),
    Sample(assembly_of_three,
           "Each solid of an assembly is classified on its own; linked copies count once.",
           "", [], "", solids=4, records=[
               ("Base block", "thin_features", [6], "normal", 1),
               ("Cover plate", "thin", [1, 4, 5], "thin", 1),
               ("Dowel pin", "normal", [], "normal", 2),
           ]),
    Sample(wedge,
           "Two faces that meet at 30 degrees: a thin edge for the paper, too little of it for the default profile.",
           "thin_features", [7], "normal"),
    Sample(nearly_square_dish, "Low and nearly square, but half empty: a dish.", "thin", [2, 4, 5, 7], "thin"),
    Sample(vee_block, "A cut-out alone makes nothing thin: a vee block.", "normal", [], "normal"),
    Sample(tapered_plug, "A compact, slightly tapered plug.", "normal", [], "normal"),
    Sample(endless_screw, "A thread that the ends and their chamfers cut off to a blade.", "thin_features", [7],
           "thin_features"),
    Sample(cuboid_with_rib, "A rib on a cuboid that is as long as wide as high: three distances inside.",
           "thin_features", [6], "thin_features"),
    Sample(pipe_bend, "A very curved part: a bend of a pipe, with a wall of 2 mm.", "thin", [3, 4], "thin"),
    Sample(plate_with_openings, "A plate whose openings leave it less than 80 % of its box.", "thin", [1, 2, 4, 5], "thin"),
    Sample(solid_casting, "The shape of the cast cover, but solid: only flange, ribs and the ring of the bore are thin.",
           "thin_features", [5, 6, 7], "thin_features"),
)
