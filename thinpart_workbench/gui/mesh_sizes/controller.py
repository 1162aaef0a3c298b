"""Controls the preparation of a mesh: from the selected part to its FEM mesh."""

import FreeCADGui as Gui
import numpy as np

from ...api.mesh_sizes import FACETS, POOR, SIZES
from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ...core.record.region_notes import notes_of_regions
from ...core.rendering.colour_scale import ColourScale
from ...freecad_adapter.objects.fem_mesh import meshed_object, missing_fem, preferred_gmsh, set_fem_mesh
from ...freecad_adapter.occurrences.active_part import selected_parts
from ...freecad_adapter.preferences import preference, preferred_analysis
from ...freecad_adapter.reading.document_parts import document_content
from ...freecad_adapter.shapes.equal_solids import motion
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, flags_as_int, translate
from ..application.sentences import translated
from ..document.part_chooser import ask_for_part
from ..document.selection import active_path, select_faces, selected_paths
from ..document.task_controller import TaskController
from ..document.task_dialog import TaskDialog
from ..document.transaction import transaction
from ..processes.size_client import SizeClient
from ..record.regions_table import kind_word
from .panel import MeshSizesPanel
from .size_nodes import SizeNodes


class MeshDialog(TaskDialog):
    """A panel with OK and Cancel; OK calls a function that says whether the panel is to be closed."""

    def __init__(self, form, accept):
        super().__init__(form, "ThinPart_MeshSizes")
        self._accept = accept

    def getStandardButtons(self):
        """OK makes the mesh."""
        box = QtWidgets.QDialogButtonBox
        return flags_as_int(box.Ok) | flags_as_int(box.Cancel) | flags_as_int(box.Help)

    def accept(self):
        """Called by FreeCAD for OK."""
        self._accept()
        return False


class MeshedDocument(SizeClient):
    """The process of a document's part: what `active_task` asks for."""

    def __init__(self, document, parent):
        super().__init__(preference("MemoryMegabytes"), preferred_gmsh(), parent)
        self.name = document.Name if document is not None else None


class MeshSizesController(TaskController):
    """Proposes element sizes for one part, has it meshed, and makes its FEM mesh.

    Parameters
    ----------
    document : FreeCAD.Document
    """

    def __init__(self, document):
        super().__init__()
        self._document = document
        self.measured = MeshedDocument(document, self)
        self._form = MeshSizesPanel()
        self.panel = MeshDialog(self._form, self._accept)
        self._part = self._owner = self._faces = self._record = None
        self._shape_hash = self._nodes = self._proposal = self._check = None
        self._sizes, self._fem_missing, self._gmsh_missing = {}, missing_fem(), ""
        self._is_accepted = self._has_left = False
        self._form.changed.connect(self._change)
        self._form.walls.edited.connect(self._edit)
        self._form.walls.faces_chosen.connect(self._select_faces)
        self._form.mesh_requested.connect(self._mesh)
        self._form.cancelled.connect(self._cancel)
        self._form.shown_changed.connect(self._show_in_view)
        self.measured.progressed.connect(lambda done: self._form.show_running(
            translate("ThinPart", "Measuring the walls of {}").format(self._part.label), done))
        self.measured.measured.connect(self._on_measured)
        self.measured.proposed.connect(self._on_proposed)
        self.measured.meshed.connect(self._on_meshed)
        self.measured.refused.connect(self._on_failed)
        self.measured.ended.connect(self._on_failed)
        self.panel.closed.connect(self._leave)
        lifelong.region_notes.answered.connect(self._on_notes)
        self._is_edited = False

    def start(self):
        """Find the part, open the panel and measure."""
        try:
            document = self._document
            content = document_content(document)
            parts = selected_parts(document, content.parts, selected_paths(document), active_path(document))
            whole = parts[0] if len(parts) == 1 else ask_for_part(parts, Gui.getMainWindow())
            if whole is None:
                return
            self._whole = whole
            self._owner, self._part, self._faces = meshed_object(document, whole)
            profile = load_profile(preference("Profile")).content
            if document.FileName:
                lifelong.region_notes.read(document.FileName)
            self.panel.show()
            self._form.show_part(self._part.label, length_unit(document))
            self._form.show_running(translate("ThinPart", "Starting to measure {}").format(self._part.label))
            self.measured.start(self._part, preferred_analysis(), profile)
        except ThinPartError as error:
            if not self.panel.is_open:
                self.panel.show()
            self._form.show_idle(False)
            self._form.show_message(translated(error))

    def close(self):
        """End the session and close the panel."""
        self._leave()
        self.panel.hide()

    def _leave(self):
        if not self._has_left:
            self._has_left = True
            lifelong.region_notes.answered.disconnect(self._on_notes)
            self._clear_view()
            self.measured.end()

    def _on_measured(self, found):
        self._record, self._gmsh_missing = found["record"], translated(found["gmsh"]) if found["gmsh"] else ""
        if self._proposal is None:
            self._take_over_notes()
        self._form.show_idle(not self._gmsh_missing)
        self._form.show_message("\n".join(filter(None, [self._gmsh_missing, translated(self._fem_missing)])))
        self._ask()

    def _on_notes(self, answer):
        if answer["document"] == self._document.FileName and self._record is not None and not self._is_edited:
            self._take_over_notes()
            self._ask()

    def _take_over_notes(self):
        """What people said of walls in the panel of the thickness map."""
        notes = (lifelong.region_notes.known(self._document.FileName) or {}).get(self._record["name"], ())
        found = notes_of_regions(self._record["regions"]["listed"], notes)
        for number, note in enumerate(found):
            if note is not None and (note.get("excluded") or note.get("mesh_size_mm")):
                self._sizes[number] = None if note.get("excluded") else note["mesh_size_mm"]

    def _request(self):
        return self._form.settings(), sorted(self._sizes.items())

    def _change(self):
        self._check = None
        self._form.show_check(None)
        self._show_in_view()
        self._ask()

    def _ask(self):
        if self._record is not None and not self.measured.is_meshing:
            self.measured.ask(*self._request())

    def _edit(self, sizes):
        self._is_edited = True
        self._sizes.update(sizes)
        self._change()

    def _on_proposed(self, found):
        self._proposal = found
        scale = self._scale()
        colours = [tuple(scale.colours([row["size"] or found["global_size"]])[0] / 255.0) for row in found["regions"]]
        self._form.show_proposal(found, colours)
        self._show_in_view()

    def _scale(self):
        return ColourScale(self._proposal["least_size"], self._proposal["global_size"], logarithmic=True)

    def _mesh(self):
        if self._gmsh_missing or self._record is None:
            return
        self._form.show_message("")
        self._form.show_running(translate("ThinPart", "Gmsh meshes {}").format(self._part.label), 0.0)
        self.measured.mesh(*self._request())

    def _cancel(self):
        """Stop Gmsh or measuring; a part that was measured is measured again, for further changes."""
        was_meshing, self._is_accepted = self.measured.is_meshing, False
        if was_meshing:
            self.measured.restart()
            self._form.show_message(translate("ThinPart", "Cancelled. Nothing was changed."))
        else:
            self.close()

    def _on_meshed(self, found):
        self._form.show_idle(True)
        self._check = found
        self._form.show_check(found)
        self._show_in_view()
        if not found["mesh"]:
            self._is_accepted = False
            self._form.show_message(translate(
                "ThinPart", "Gmsh made no mesh ({}): try fewer layers, a smaller largest size, or switch a wall off. "
                            "Nothing was changed.").format(translated(found["proposed"]["reason"])))
        elif self._is_accepted:
            self._make()

    def _on_failed(self, sentence):
        self._is_accepted = False
        self._form.show_idle(False)
        self._form.show_message(sentence)

    def _accept(self):
        sentence = translated(self._fem_missing) or self._gmsh_missing
        if sentence or self._record is None:
            if sentence:
                self._form.show_message(sentence)
            return
        self._is_accepted = True
        if self._check is not None and self._check["mesh"]:
            self._make()
        elif not self.measured.is_meshing:
            self._mesh()

    def _make(self):
        """Make or update the FEM mesh in one step of undo, and close the panel."""
        self._is_accepted = False
        document = self._document
        if document.getObject(self._owner.Name) is None or not self._owner.Shape.Solids[0].isPartner(self._part.shape):
            self._form.show_message(translate(
                "ThinPart", "The document has changed while it was meshed: start again. Nothing was changed."))
            return
        unit = length_unit(document)
        walls = [(translate("ThinPart", "{} of {}: elements of {}").format(
            kind_word(row["kind"]), unit.text(row["thickness"]), unit.text(row["size"])), row["size"],
            [self._faces[face] for face in row["faces"]]) for row in self._proposal["regions"] if row["size"] is not None]
        settings, sizes = self._request()
        try:
            with transaction(document, translate("ThinPart", "Prepare mesh")):
                set_fem_mesh(document, self._owner, self._check["mesh"], {**settings, "walls": sizes},
                             self._proposal["global_size"], settings["order"], walls)
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        QtCore.QTimer.singleShot(0, self.close)

    def _select_faces(self, faces):
        if not self._has_left:
            select_faces(self._document, self._whole, faces)

    def _show_in_view(self):
        """Show sizes and poor elements, as the panel says."""
        nodes = self._view_nodes()
        if nodes is None or self._proposal is None or self.measured.folder is None:
            return
        if self._form.preview.isChecked():
            corners, sizes = (np.load(self.measured.file(name)) for name in (FACETS, SIZES))
            nodes.show_sizes(corners, self._scale().colours(sizes.ravel()).reshape(-1, 3, 3))
        else:
            nodes.hide_sizes()
        if self._check is not None and self._form.poor.isChecked():
            nodes.show_poor(np.load(self.measured.file(POOR)))
        else:
            nodes.hide_poor()

    def _view_nodes(self):
        if self._nodes is None:
            view = next(iter(Gui.getDocument(self._document.Name).mdiViewsOfType("Gui::View3DInventor")), None)
            if view is None:
                return None
            self._nodes = SizeNodes(view.getSceneGraph(), motion(self._part.shape, self._whole.shape))
        return self._nodes

    def _clear_view(self):
        nodes, self._nodes = self._nodes, None
        if nodes is not None:
            nodes.clear()
