"""The table of samples: what each shows, and what the `paper` profile should say about it."""

from dataclasses import dataclass, field

from .assembly import assembly_of_three
from .normal_parts import block, tapered_plug, vee_block
from .thin_features import (
    flange, gear_thin_teeth, ribbed_block, spur_gear_on_hub, wedge, worm_run_out,
)
from .thin_parts import (
    bent_sheet_bracket, heat_sink, nearly_square_dish, plate, shaft, thin_walled_casting, tube,
)


@dataclass(frozen=True)
class Sample:
    """A part to make, and what the `paper` profile should say about it.

    Attributes
    ----------
    build : callable
        From a document to its results, a list of objects.
    shows : str
    category : str
    criteria : list of int
    solids : int
    records : list of (str, str, list of int, int)
        Label, category, criteria and instances by solid: an assembly is classified solid by solid.
    """

    build: object
    shows: str
    category: str
    criteria: list
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
            "category": self.category or None,
            "criteria": self.criteria,
        }
        if self.records:
            keys = ("label", "category", "criteria", "instances")
            entry["solids"] = [dict(zip(keys, record)) for record in self.records]
        return entry


SAMPLES = (
    Sample(plate, "A flat plate fills its low, wide bounding box.", "thin", [1, 4, 5]),
    Sample(bent_sheet_bracket, "Bent sheet metal fills little of its bounding box.", "thin", [3, 4]),
    Sample(tube, "A thin wall need not be flat: a tube, 2 mm thick all round.", "thin", [3, 4]),
    Sample(ribbed_block, "A solid block with one thin rib, shown where it is.", "thin_features", [5]),
    Sample(gear_thin_teeth, "Pointed teeth have no parallel faces: their flanks meet at a sharp angle.",
           "thin_features", [6, 7]),
    Sample(spur_gear_on_hub, "Involute teeth narrow towards their tips, on a solid gear body.",
           "thin_features", [7]),
    Sample(heat_sink, "Most of the surface belongs to thin fins, so the part is thin as a whole.",
           "thin", [4, 5]),
    Sample(worm_run_out, "A thread that runs out to nothing leaves slivers that are hard to mesh.",
           "thin_features", [7]),
    Sample(thin_walled_casting, "A cast cover: thin walls all over, with ribs, a boss and fillets.",
           "thin", [3, 4, 7]),
    Sample(shaft, "A slender shaft counts as thin: its diameters are small against its length.",
           "thin", [4]),
    Sample(block, "A compact block with rounded edges.", "normal", []),
    Sample(flange, "A thin disc beside a thick stub: neither is below 5 % of the diagonal.",
           "thin_features", [6]),
    Sample(assembly_of_three,
           "Each solid of an assembly is classified on its own; linked copies count once.",
           "", [], solids=4, records=[
               ("Base block", "thin_features", [6], 1),
               ("Cover plate", "thin", [1, 4, 5], 1),
               ("Dowel pin", "normal", [], 2),
           ]),
    Sample(wedge, "Two faces that meet at 30 degrees make a thin edge.", "thin_features", [7]),
    Sample(nearly_square_dish, "Low and nearly square, but half empty: a dish.", "thin", [2, 4, 5, 7]),
    Sample(vee_block, "A cut-out alone makes nothing thin: a vee block.", "normal", []),
    Sample(tapered_plug, "A compact, slightly tapered plug.", "normal", []),
)
