# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents of FreeCAD's Assembly workbench, made as that workbench makes them; FreeCAD 1.0 and later have it."""

from dataclasses import dataclass

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

App = load_freecad()


def has_assembly_workbench():
    """Whether this FreeCAD has the workbench."""
    return _joints() is not None


def _joints():
    try:
        import JointObject
    except ImportError:
        return None
    return JointObject


@dataclass
class MadeAssembly:
    """What `save_assembly` has made.

    Attributes
    ----------
    main, parts, sub : str
        The files: the assembly, the parts that it links to, the assembly that it links to.
    instances : dict
        How often a solid stands in the assembly, by its volume in mm3.
    """

    main: str
    parts: str
    sub: str
    instances: dict


PLATE, PIN, LEAF, BRACE = 40.0 * 30.0 * 2.0, 4.0 * 4.0 * 20.0, 12.0 * 8.0, 5.0 * 5.0 * 30.0
FOOT, CASE = 10.0 ** 3, 60.0 * 50.0 * 5.0
"""Volumes of the parts, mm3."""


def save_assembly(folder):
    """Save an assembly of linked and own parts, with all that the workbench puts beside them.

    Parameters
    ----------
    folder : Path
        An empty one.

    Returns
    -------
    MadeAssembly
        All its documents are open; `main` is the active one.

    Notes
    -----
    The parts lie in a document of their own; a second one is an assembly of two plates that stand apart,
    and is linked to rigidly and flexibly.
    """
    parts = App.newDocument("Parts")
    body = parts.addObject("PartDesign::Body", "Plate")
    block = body.newObject("PartDesign::AdditiveBox", "Block")
    block.Length, block.Width, block.Height = 40.0, 30.0, 2.0
    pin = _box(parts, "Pin", 4.0, 4.0, 20.0)
    hinge = parts.addObject("App::Part", "Hinge")
    for name, x in (("Leaf", 0.0), ("OtherLeaf", 20.0)):
        leaf = hinge.newObject("Part::Box", name)
        leaf.Length, leaf.Width, leaf.Height = 12.0, 8.0, 1.0
        leaf.Placement.Base = App.Vector(x, 0.0, 0.0)
    parts = _saved(parts, folder)

    sub = _saved(App.newDocument("Sub"), folder)
    frame = _new_assembly(sub, "Frame")
    lower, upper = (_link(frame, name, body, (0.0, 0.0, z)) for name, z in (("Lower", 0.0), ("Upper", 25.0)))
    _ground(frame, lower)
    _fix(frame, lower, "Block.Face6", upper, "Block.Face5", solve=False)
    brace = frame.newObject("Part::Box", "Brace")
    brace.Length, brace.Width, brace.Height = 5.0, 5.0, 30.0
    _link(frame, "SubHinge", hinge, (50.0, 0.0, 0.0))
    _saved(sub, folder)

    main = _saved(App.newDocument("Main"), folder)
    machine = _new_assembly(main, "Machine")
    case = machine.newObject("Part::Box", "Case")
    case.Length, case.Width, case.Height = 60.0, 50.0, 5.0
    case.Placement.Base = App.Vector(0.0, 0.0, -100.0)
    first = _link(machine, "FirstPlate", body, (100.0, 0.0, 0.0))
    _link(machine, "SecondPlate", body, (100.0, 0.0, 50.0), App.Rotation(App.Vector(1, 0, 0), 90.0))
    pins = _link(machine, "Pins", pin, (0.0, 200.0, 0.0))
    pins.ElementCount = 3
    for index, element in enumerate(pins.ElementList):
        element.Placement.Base = App.Vector(10.0 * index, 0.0, 0.0)
    _link(machine, "MainHinge", hinge, (0.0, 0.0, 300.0))
    feet = machine.newObject("Assembly::AssemblyObject", "Feet")
    feet.Type = "Assembly"
    feet.newObject("Assembly::JointGroup", "Joints")
    feet.Placement.Base = App.Vector(0.0, -200.0, 0.0)
    foot = feet.newObject("Part::Box", "Foot")
    foot.Placement.Base = App.Vector(0.0, 0.0, 7.0)
    for name, rigid, x in (("Stiff", True, 300.0), ("Loose", False, 400.0)):
        linked = machine.newObject("Assembly::AssemblyLink", name)
        linked.LinkedObject = frame
        linked.Rigid = rigid
        linked.Placement.Base = App.Vector(x, 0.0, 0.0)
    main.recompute()
    _ground(machine, case)
    _fix(machine, case, "Face6", first, "Block.Face5")
    _explode(machine, first)
    _list_parts(machine)
    _simulate(machine)
    _saved(main, folder)
    return MadeAssembly(main.FileName, parts.FileName, sub.FileName, {PLATE: 6, PIN: 3, LEAF: 6, BRACE: 2, FOOT: 1, CASE: 1})


def _box(document, name, length, width, height):
    box = document.addObject("Part::Box", name)
    box.Length, box.Width, box.Height = length, width, height
    return box


def _new_assembly(document, name):
    assembly = document.addObject("Assembly::AssemblyObject", name)
    assembly.Type = "Assembly"
    assembly.newObject("Assembly::JointGroup", "Joints")
    return assembly


def _link(assembly, name, linked, base, rotation=None):
    link = assembly.newObject("App::Link", name)
    link.LinkedObject = linked
    link.Placement = App.Placement(App.Vector(*base), App.Rotation() if rotation is None else rotation)
    return link


def _joint_group(assembly):
    return next(each for each in assembly.Group if each.TypeId == "Assembly::JointGroup")


def _ground(assembly, component):
    grounded = _joint_group(assembly).newObject("App::FeaturePython", "GroundedJoint")
    _joints().GroundedJoint(grounded, component)
    if App.GuiUp:
        _joints().ViewProviderGroundedJoint(grounded.ViewObject)


def _fix(assembly, one, face, other, other_face, solve=True):
    joint = _joint_group(assembly).newObject("App::FeaturePython", "Joint")
    _joints().Joint(joint, 0)
    if App.GuiUp:
        _joints().ViewProviderJoint(joint.ViewObject)
    references = [[each, [where, where]] for each, where in ((one, face), (other, other_face))]
    joint.Reference1, joint.Reference2 = references
    if solve:
        joint.Proxy.updateJCSPlacements(joint)


def _explode(assembly, component):
    group = assembly.newObject("Assembly::ViewGroup", "Exploded Views")
    view = group.newObject("App::FeaturePython", "Exploded View")
    step = assembly.newObject("App::FeaturePython", "Move")
    if App.GuiUp:
        import CommandCreateView  # it needs a window

        CommandCreateView.ExplodedView(view)
        CommandCreateView.ViewProviderExplodedView(view.ViewObject)
        CommandCreateView.ExplodedViewStep(step)
        CommandCreateView.ViewProviderExplodedViewStep(step.ViewObject)
        step.References = [assembly, [component.Name + "."]]
        step.MovementTransform = App.Placement(App.Vector(0.0, 0.0, 80.0), App.Rotation())
    else:
        view.addExtension("App::GroupExtensionPython")
    setattr(view, "Group" if hasattr(view, "Group") else "Moves", [step])  # FreeCAD 1.0 has Moves


def _list_parts(assembly):
    group = assembly.newObject("Assembly::BomGroup", "Bills of Materials")
    listed = group.newObject("Assembly::BomObject", "Bill of Materials")
    listed.columnsNames = ["Index", "Name", "Quantity"]


def _simulate(assembly):
    if "Assembly::SimulationGroup" not in assembly.Document.supportedTypes():
        return  # FreeCAD 1.0 has none
    group = assembly.newObject("Assembly::SimulationGroup", "Simulations")
    simulation = group.newObject("App::FeaturePython", "Simulation")
    if App.GuiUp:
        import CommandCreateSimulation

        CommandCreateSimulation.Simulation(simulation)


def _saved(document, folder):
    """The document; only one that is saved may link to others."""
    document.recompute()
    document.saveAs(str(folder / f"{document.Name}.FCStd"))
    return document
