# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every tolerance of the measurement in one place, each with its reason; and where those of single steps are."""

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

    floor: float = 1e-4
    """Share of the surface below which a finding counts as a stray ray: walls that cover less are not the thinnest wall,
    and `min_nonparallel` is recorded at this floor."""

    face_floor: float = 0.1
    """Share of a face's walls that its thinnest one needs where that is less than the floor."""

    touching: float = 1e-3
    """Share of the median wall under which what a ray finds is no wall: there surfaces touch, or cross."""

    alike: float = 1.25
    """Thicknesses up to this ratio are those of one wall, and sizes of elements up to it are one size: a web of 5 mm and a
    flange of 8 mm are two walls, a casting whose thickness varies is one."""

    zero_volume: float = 1e-9
    """A closed surface that encloses less than this share of its area times its diagonal is flat. (Compared
    with the cubed diagonal, a rod 50,000 times as long as thick would count as flat.)"""


TOLERANCES = Tolerances()

ELSEWHERE = (
    "core.descriptors.automatic_mesh",  # short edges, narrow faces, tight curves, knife's edges
    "core.descriptors.equal_walls",  # walls that are equal
    "core.descriptors.local_quantiles",  # shares of the surface whose local thickness is recorded
    "core.descriptors.precision",  # errors of shares, of the volume and of the area
    "core.descriptors.quantity",  # where an edge of a bin is blurred
    "core.descriptors.region_kinds",  # threads
    "core.descriptors.ridges",  # pins, and cores that are thick beside ridges
    "core.forms.alignment",  # turns that are tried, points of two outlines that belong together
    "core.forms.comparison",  # geometry that is the same
    "core.forms.equal_faces",  # faces that are equal
    "core.forms.form",  # what a turned normal counts as
    "core.forms.laying",  # outlines that are the same
    "core.judging.classification",  # the thin limit of a profile that states none
    "core.judging.criteria",  # the greatest margin of a profile
    "core.judging.limit_bands",  # walls just above a limit
    "core.judging.threshold_search",  # steps of learned thresholds
    "core.judging.verdict_sentence",  # the least share that is said
    "core.judging.wall_words",  # walls of one thickness, what a part is made of, sheets
    "core.judging.wall_check",  # a mesh that is too coarse for a limit, thick and thin walls, walls near a limit
    "core.maps.facet_refinement",  # the longest facet, and how many there are
    "core.maps.map_changes",  # changes of thickness that are listed
    "core.maps.jump_lines",  # jumps of thickness along the sides of facets
    "core.maps.level_cuts",  # facets of one thickness
    "core.maps.map_outline",  # creases that are drawn
    "core.maps.map_summary",  # the range of colours, and walls that lie outside of it
    "core.maps.seen_walls",  # walls that a point sees aside
    "core.maps.thickness_map",  # jumps within a facet
    "core.mesh.bounds",  # boxes that are equal, flat sides
    "core.mesh.box_refinement",  # the least gain for which a box is turned
    "core.mesh.resolution",  # facets whose normals are turned
    "core.mesh.smooth_normals",  # creases
    "core.mesh.second_order",  # elements that are inside out
    "core.mesh.surface_mesh",  # slits in a mesh that counts as closed
    "core.mesh.tetrahedra",  # poor tetrahedra
    "core.rays.ray_casting",  # boxes that a ray grazes
    "core.rays.ray_packets",  # rays that are cast together
    "core.record.face_check",  # walls near a limit of their face
    "core.record.face_limits",  # faces that are the same after a change
    "core.record.mesh_settings",  # parts alike and walls that are the same, for settings that worked
    "core.record.region_notes",  # regions that are the same after a change
    "core.record.thin_faces",  # faces that are shown as thin
    "core.reuse.likeness",  # parts of one form, parts that are alike, scales that people know
    "core.reuse.similarity",  # how near two parts are that are alike
    "core.risk.mesh_risk",  # what raises a risk
    "core.record.thinnest_sentence",  # sharp edges that are named
    "core.shells.facing_faces",  # sides of a wall
    "core.shells.mixed_mesh",  # nodes beside a face that they are tied to
    "core.shells.moved_side",  # nodes that are moved from a side to the middle of a wall
    "core.shells.open_ends",  # free edges of a shell inside the material
    "core.shells.shell_mesh",  # thicknesses of elements that are one property
    "core.shells.shell_or_solid",  # parts to be meshed as shells
    "core.shells.shell_settings",  # element sizes of shells
    "core.shells.sound_triangles",  # triangles that a solver takes
    "core.shells.wall_sides",  # faces on one side of a wall
    "core.sizing.element_estimate",  # elements in a volume and under a surface
    "core.sizing.error_law",  # sizes for an error of an analysis
    "core.sizing.size_boxes",  # cubes outside of the part
    "core.sizing.size_field",  # sizes that are searched together
    "core.sizing.size_proposal",  # how near to the budget a proposal has to be
    "core.sizing.size_sources",  # chord errors, narrow faces, walls of a region
    "core.sizing.sizing_settings",  # least and greatest size of elements
    "core.thickness.inscribed_balls",  # when a ball is empty
    "core.thickness.listed_regions",  # regions that are listed and counted
    "core.thickness.local_thickness",  # how far a ball reaches
    "core.thickness.measurement",  # progress
    "core.thickness.nonparallel",  # the greatest distance of slanted walls that is searched
    "core.thickness.plate_likeness",  # places of a wall that are plates
    "core.thickness.region_shape",  # plates, bars, blocks, tubes, tapers and teeth
    "core.thickness.wall_graph",  # neighbours on one wall
    "core.thickness.wall_regions",  # regions that are plates, faces that belong to one
    "core.walls.face_thickness",  # walls of a face that are as thin as the thinnest
    "core.walls.near_walls",  # places between equal faces that are no walls either
    "core.walls.thickness_field",  # errors of wedge angles
    "core.walls.thin_places",  # the depth beside sharp edges, edges that are walls
    "core.walls.walls",  # parallel and tapered walls: angles
    "freecad_adapter.exact_walls.face_places",  # flanks of threads
    "freecad_adapter.mid_surface.bridges",  # joints of mid-surfaces
    "freecad_adapter.mid_surface.cut_faces",  # time for cutting mid-surfaces
    "freecad_adapter.mid_surface.mid_faces",  # walls that have a mid-surface, walls that have one together
    "freecad_adapter.mid_surface.mid_shapes",  # round walls
    "freecad_adapter.mid_surface.side_faces",  # curvature of most of a face
    "freecad_adapter.mid_surface.smooth_cuts",  # faces that meet smoothly
    "freecad_adapter.mid_surface.solid_rest",  # walls that go over into a solid, thick bodies
    "freecad_adapter.objects.thickness_probes",  # probes on a surface that was measured again
    "freecad_adapter.reading.sewn_solids",  # gaps that sewing closes
    "freecad_adapter.shapes.mended_solid",  # solids that are the same after mending
    "freecad_adapter.shapes.tolerances",  # solids, points and placements that are the same
    "freecad_adapter.tessellating.tessellation",  # angles between facets
)
"""Modules with limits that belong to one step; each limit has its reason there."""
