# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start-up script for `window.py`: presses the buttons and times what comes of it."""

import json
import os
import sys
import time
import traceback

FRAMES = 15
STEP = 0.05
"""Radians that the camera turns from one frame to the next."""


def main():
    root, output, turns, parts = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
    status = 1
    try:
        sys.path[:0] = [root, os.path.join(root, "tests"), os.path.join(root, "tests", "gui")]
        found = _measured(turns, parts)
        with open(output, "w", encoding="utf-8") as file:
            json.dump(found, file)
        status = 0
    except BaseException:  # whatever it was: FreeCAD must end, and tell
        traceback.print_exc(file=sys.__stderr__)
    finally:
        # FreeCAD would ask whether to save the documents.
        os._exit(status)


def _measured(turns, parts):
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    Gui.activateWorkbench("ThinPartWorkbench")
    window.settle(2000)
    version = ".".join(App.Version()[:3]).split()[0]
    document = App.newDocument("Warm")
    window.add(document, "Plate", dimpled_plate(1))
    _press()  # what is loaded at the first time only is not what is measured here
    App.closeDocument(document.Name)
    if parts:
        return {"freecad": version, "parts": [_coloured(part) for part in parts]}
    times = [_turn(12) for _ in range(turns)]
    return {"freecad": version, "turns": times, "idle_gap": _idle_gap(max(turn["coloured"] for turn in times)),
            "scenes": dict(_scenes(23))}


def dimpled_plate(dimples):
    """A plate with so many round dimples, 3 mm thick under them: about 8,700 triangles each as people start it."""
    import Part
    from FreeCAD import Vector

    places = [(15 + 24 * (number % 4), 15 + 24 * (number // 4)) for number in range(dimples)]
    balls = [Part.makeSphere(9, Vector(x, y, 12)) for x, y in places]
    return Part.makeBox(102, 6 + 24 * -(-dimples // 4), 12).cut(Part.makeCompound(balls))


def _press():
    """Show thickness, and wait for the first frame that is drawn after the panel tells of the map."""
    import window_actions as window

    window.show_thickness()
    drawn = Drawn()
    drawn.next()
    drawn.end()


def _turn(dimples):
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.api.document_maps import parts_of
    from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects

    document = App.newDocument("Plate")
    window.add(document, "Plate", dimpled_plate(dimples))
    Gui.runCommand("Std_ViewFitAll")
    window.settle(3000)
    gaps = Gaps()
    begun = time.perf_counter()
    _press()
    taken = time.perf_counter() - begun
    window.settle(300)
    gap = gaps.end()
    part, = parts_of(thickness_objects(document)[0])
    App.closeDocument(document.Name)
    seconds = part.record["seconds"]
    return {"coloured": taken, "tessellate": seconds["tessellate"], "measure": seconds["measure"], "gap": gap,
            "triangles": part.record["triangles"], "facets": part.map.count}


def _coloured(path):
    """How soon a part is coloured: first coarsely, then finely; and how soon *Cancel* is obeyed."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import window_actions as window

    from thinpart_workbench.api.document_maps import parts_of
    from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
    from thinpart_workbench.gui.application import lifelong

    document = _opened(path)
    Gui.runCommand("Std_ViewFitAll")
    window.settle(3000)  # the process that measures has loaded everything
    first = lifelong.map_events.first_colours
    window.press("ThinPart_ShowThickness")
    window.wait_until(lambda: document.Name in first or window.is_thickness_told(), seconds=600)
    window.settle(500)
    begun = time.perf_counter()
    if window.is_shown("ThinPart_CancelButton"):
        window.click("ThinPart_CancelButton")
    window.settle(1)
    cancel = time.perf_counter() - begun
    window.mouse_click(window.close_button())
    for thickness in thickness_objects(document):
        document.removeObject(thickness.Name)
    window.settle(4000)
    drawn, begun = Drawn(), time.perf_counter()
    window.press("ThinPart_ShowThickness")
    window.wait_until(lambda: document.Name in first or window.is_thickness_told(), seconds=600)
    coarse = [part.map.count for part in first[document.Name].coloured] if document.Name in first else []
    drawn.again()
    seconds = time.perf_counter() - begun
    window.wait_until(lambda: window.is_thickness_told() and document.Name not in first, seconds=600)
    drawn.again()
    final = time.perf_counter() - begun
    drawn.end()
    fine = [part for thickness in thickness_objects(document) for part in parts_of(thickness)]
    App.closeDocument(document.Name)
    window.settle(500)
    return {"kilobytes": round(os.path.getsize(path) / 1000), "faces": sum(len(part.record["faces"]) for part in fine),
            "first": seconds if coarse else final, "final": final, "cancel": cancel,
            "first_facets": sum(coarse), "facets": sum(part.map.count for part in fine)}


def _opened(path):
    import FreeCAD as App
    import Mesh
    import Part

    if path.lower().endswith(".fcstd"):
        return App.openDocument(path)
    document = App.newDocument("Part")
    (Mesh if path.lower().endswith(".stl") else Part).insert(path, document.Name)
    return document


def _idle_gap(seconds):
    """The longest time without an event while there is a part and nothing is done with it."""
    import FreeCAD as App
    import window_actions as window

    document = App.newDocument("Plate")
    window.add(document, "Plate", dimpled_plate(1))
    window.settle(3000)
    gaps = Gaps()
    window.settle(1000.0 * seconds)
    gap = gaps.end()
    App.closeDocument(document.Name)
    return gap


class Gaps:
    """The longest time between two events of a timer of the window."""

    def __init__(self):
        from thinpart_workbench.gui.application.qt import QtCore

        self._longest, self._last = 0.0, time.perf_counter()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._tick)
        self._timer.start(5)

    def end(self):
        """float: seconds."""
        self._timer.stop()
        self._tick()
        return self._longest

    def _tick(self):
        now = time.perf_counter()
        self._longest, self._last = max(self._longest, now - self._last), now


def _scenes(dimples):
    """Pairs of a name and what turns how fast, all in the same view."""
    import FreeCAD as App
    import FreeCADGui as Gui
    import Mesh
    import MeshPart
    import window_actions as window

    from thinpart_workbench.api.document_maps import parts_of
    from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
    from thinpart_workbench.gui.view3d.facet_nodes import FEW

    document = App.newDocument("Frames")
    yield "an empty view", {"facets": 0, "frames": _frames()}
    shape = dimpled_plate(dimples)
    mesh = document.addObject("Mesh::Feature", "Mesh")
    mesh.Mesh = Mesh.Mesh(MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=1e-3 * shape.BoundBox.DiagonalLength, AngularDeflection=0.0698))
    document.recompute()
    Gui.runCommand("Std_ViewFitAll")
    window.settle(2000)
    yield "FreeCAD's own mesh", {"facets": mesh.Mesh.CountFacets, "frames": _frames()}
    _press()
    thickness, = thickness_objects(document)
    part, = parts_of(thickness)
    mesh.ViewObject.Visibility = False
    window.settle(2000)
    yield "the map of it", {"facets": part.map.count, "frames": _frames()}
    thickness.ViewObject.Proxy.coarsen(True)
    yield "the map of it while it turns", {"facets": FEW, "frames": _frames()}
    thickness.ViewObject.Proxy.coarsen(False)


def _frames():
    import FreeCADGui as Gui
    from pivy import coin

    camera = Gui.ActiveDocument.ActiveView.getCameraNode()
    turn = coin.SbRotation(coin.SbVec3f(0, 1, 0), STEP)
    drawn, times = Drawn(), []
    for _ in range(FRAMES):
        begun = time.perf_counter()
        camera.orientation = turn * camera.orientation.getValue()
        drawn.next()
        times.append(time.perf_counter() - begun)
    drawn.end()
    return times[3:]  # the first ones fill the buffers of the graphics card


class Drawn:
    """Counts the frames that the active view draws."""

    def __init__(self):
        import FreeCADGui as Gui
        from pivy import coin

        self.count = 0
        self._node = coin.SoCallback()
        self._node.setCallback(self._called)
        self._scene = Gui.ActiveDocument.ActiveView.getSceneGraph()
        self._scene.addChild(self._node)

    def next(self):
        """Wait until one more frame is drawn and all that follows on it is done."""
        from thinpart_workbench.gui.application.qt import QtWidgets

        before, until = self.count, time.perf_counter() + 60.0
        while self.count == before:
            QtWidgets.QApplication.processEvents()
            if time.perf_counter() > until:
                raise TimeoutError("The view was not drawn.")

    def again(self):
        """Have one more frame drawn, and wait for it."""
        self._node.touch()
        self.next()

    def end(self):
        """Leave the scene as it was."""
        self._scene.removeChild(self._node)

    def _called(self, _data, action):
        from pivy import coin

        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self.count += 1


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(0, main)
