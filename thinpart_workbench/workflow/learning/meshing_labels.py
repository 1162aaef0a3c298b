"""Labels without a person: what is in trouble where Gmsh meshes it is thin."""

from dataclasses import asdict, dataclass
from typing import Optional

from ...core.categories import NORMAL
from ...core.descriptors.descriptor_table import Descriptors
from ...core.message import message
from ...storage.labels_file import Label

LOCAL = 0.05
"""Share of the surface on bad tetrahedra from which a part is in trouble: strays on 2 % are there in plain blocks too."""

SPREAD = 0.5
"""Share of the surface on bad tetrahedra from which the trouble is spread over the part."""

THIN, THIN_FEATURES = "thin", "thin_features"


@dataclass(frozen=True)
class MeshedResult:
    """How Gmsh did with a part.

    Attributes
    ----------
    file, part : str
        Path of the document below the library; name of the part.
    elements : int
        Tetrahedra.
    least_ratio, trouble_share : float or None
        Least ratio of radii, and share of the surface on bad tetrahedra; None without a mesh.
    reason : str
        Why there is no mesh.
    descriptors : Descriptors
    """

    file: str
    part: str
    elements: int
    least_ratio: Optional[float]
    trouble_share: Optional[float]
    reason: str
    descriptors: Descriptors

    @property
    def has_trouble(self):
        """bool: whether there is no mesh, or bad tetrahedra on more than `LOCAL` of the surface."""
        return self.trouble_share is None or self.trouble_share > LOCAL

    @property
    def category(self):
        """str: what the part is by its mesh."""
        if not self.has_trouble:
            return NORMAL
        return THIN if self.trouble_share is None or self.trouble_share >= SPREAD else THIN_FEATURES

    def label(self, person):
        """The `Label` of the part. Without a mesh nobody knows where the trouble is, so it is unsure."""
        meshed = self.trouble_share is not None
        return Label(message("{file}, part {part}", file=self.file, part=self.part), self.file, self.part, self.category,
                     "" if meshed else THIN_FEATURES, meshed, person, None)

    def row(self):
        """The result as JSON values."""
        return {"file": self.file, "part": self.part, "category": self.category, "trouble": self.has_trouble,
                "elements": self.elements, "least_ratio": self.least_ratio, "trouble_share": self.trouble_share,
                "reason": self.reason}


@dataclass(frozen=True)
class Meshing:
    """How Gmsh did with the parts of a library, and which quantities foretell that.

    Attributes
    ----------
    person : str
        "gmsh" and its version.
    results : tuple of MeshedResult
    failures : tuple of dict
        ``file``, ``part`` and ``message`` of what could not be given to Gmsh.
    quantities : tuple of Foretelling
        The best first; empty where all parts have trouble, or none.
    seconds : float
    """

    person: str
    results: tuple
    failures: tuple
    quantities: tuple
    seconds: float

    def as_dict(self):
        """All as JSON values."""
        return {"gmsh": self.person, "seconds": self.seconds, "parts": [result.row() for result in self.results],
                "failures": list(self.failures), "quantities": [asdict(each) for each in self.quantities],
                "local": LOCAL, "spread": SPREAD}

    @property
    def labels(self):
        """list of Label"""
        return [result.label(self.person) for result in self.results]
