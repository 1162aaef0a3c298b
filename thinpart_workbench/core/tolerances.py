"""Every tolerance of the measurement in one place, each with its reason."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Tolerances:
    """Lengths are shares of the diagonal of the part, so that scale changes nothing."""

    weld: float = 1e-7
    """Vertices nearer than this are one vertex. STL keeps float32 (6e-8 of the coordinate)."""

    zero_height: float = 1e-10
    """A triangle lower than this has no usable normal and is dropped as degenerate."""

    flat: float = 3e-7
    """Points no farther than this from a plane are meant to lie in it: float32 keeps them no better."""

    self_hit: float = 1e-6
    """A hit nearer than this is the ray's own surface, or a second solid that touches it there."""

    beside_edge: float = 1e-4
    """Samples nearer to an edge than this say nothing about a surface that passes through itself."""

    edge: float = 1e-9
    """Barycentric slack, so that no ray slips between two triangles that share an edge."""

    gap: float = 1e-6
    """Cracks no wider than this between triangles that do not share their edges are closed: a ray
    this near to a triangle meets it."""

    grazing: float = 2e-6
    """Cosine under which a triangle is seen edge-on and cannot be hit. Float32 has to know it from
    zero: the walls beside a ray are seen so, and they are many."""

    bin_edge: float = 1e-7
    """A distance this little under a bin edge lies on it: a wall that is exactly 5 % of the
    diagonal falls on the same side under every rotation."""

    angle: float = 1e-5
    """Radians under a limit angle that count as that angle, for the same reason."""

    box_tie: float = 1e-3
    """Boxes whose volumes agree to this share are ties; the shortest diagonal is taken."""

    zero_volume: float = 1e-9
    """A closed surface that encloses less than this share of its cubed diagonal is flat."""


TOLERANCES = Tolerances()
