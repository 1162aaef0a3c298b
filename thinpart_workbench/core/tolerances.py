"""Every tolerance of the measurement in one place, each with its reason."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Tolerances:
    """Lengths are shares of the diagonal of the part, so that scale changes nothing."""

    weld: float = 1e-7
    """Vertices nearer than this are one vertex. STL keeps float32 (6e-8 of the coordinate)."""

    zero_height: float = 1e-10
    """A triangle lower than this has no usable normal and is dropped as degenerate."""

    rounding: float = 2e-7
    """Mesh points are float32, so they lie no farther than this from their exact positions."""

    flat: float = 3e-7
    """Points no farther than this from a plane are taken to lie in it: float32 is no more precise."""

    self_hit: float = 1e-6
    """A hit nearer than this is on the surface where the ray starts, or on a second solid that touches it there."""

    beside_edge: float = 1e-4
    """Samples nearer to an edge than this are not used to find a surface that intersects itself."""

    edge: float = 1e-9
    """Barycentric slack, so that no ray slips between two triangles that share an edge."""

    gap: float = 1e-6
    """Cracks no wider than this between triangles that do not share their edges are closed: a ray this near to a
    triangle hits it."""

    grazing: float = 2e-6
    """Cosine under which a triangle is edge-on to a ray and cannot be hit. Float32 must still tell it from zero,
    because the many side walls along a ray are edge-on to it."""

    bin_edge: float = 1e-7
    """A distance less than this below a bin edge counts as on the edge, so that a wall of exactly 5 % of the
    diagonal falls into the same bin under every rotation."""

    threshold: float = 1e-6
    """A ratio this near to a criterion's threshold, as a share of it, counts as equal, so that neither ``>`` nor
    ``<`` holds: a box 12 times as wide as high is classified alike under every rotation."""

    angle: float = 1e-5
    """Radians: an angle less than this below a limit counts as the limit, for the same reason."""

    box_tie: float = 1e-3
    """Boxes whose volumes agree to this share are ties; the one with the shortest diagonal is chosen."""

    zero_volume: float = 1e-9
    """A closed surface that encloses less than this share of its area times its diagonal is flat. (Compared
    with the cubed diagonal, a rod 50,000 times as long as thick would count as flat.)"""


TOLERANCES = Tolerances()
