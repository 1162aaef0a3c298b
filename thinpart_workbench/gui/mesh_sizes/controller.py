"""Controls the preparation of a mesh: from the selected part to its FEM mesh."""

import FreeCADGui as Gui
import numpy as np

from ...api.mesh_sizes import (
    FACETS,
    POOR,
    SHELL_FACETS,
    SHELL_MESH,
    SHELL_SHAPE,
    SHELL_THICKNESS,
    SIZES,
)
from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ...core.number_text import percent
from ...core.record.region_notes import notes_of_regions
from ...core.rendering.colour_scale import ColourScale
from ...core.shells.shell_mesh import ALIKE
from ...core.sizing.sizing_settings import LAYERS_OF_ORDER
from ...freecad_adapter.objects.fem_mesh import meshed_object, missing_fem, preferred_gmsh, set_fem_mesh
from ...freecad_adapter.objects.fem_shell import set_fem_shell
from ...freecad_adapter.occurrence import object_at
from ...freecad_adapter.occurrences.active_part import selected_parts
from ...freecad_adapter.preferences import preference, preferred_analysis
from ...freecad_adapter.reading.document_parts import document_content
from ...freecad_adapter.shapes.equal_solids import motion
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, flags_as_int, grouped, translate
from ..application.sentences import translated
from ..document.part_chooser import ask_for_part
from ..document.selection import active_path, select_faces, selected_paths
from ..document.task_controller import TaskController
from ..document.task_dialog import TaskDialog
from ..document.transaction import transaction
from ..processes.size_client import SizeClient
from ..record.regions_table import kind_word
from ..view3d.covered_sources import CoveredSources
from .active_analysis import active_analysis
from .panel import MeshSizesPanel
from .size_nodes import SizeNodes


class MeshDialog(TaskDialog):
    """A panel with OK and Cancel; OK calls a function that says whether the panel is to be closed."""

    def __init__(self, form, accept):
        super().__init__(form, "ThinPart_MeshSizes")
        self._accept = accept

    def getStandardButtons(self):
        """OK makes the mesh."""
        buttons = QtWidgets.QDialogButtonBox.Ok, QtWidgets.QDialogButtonBox.Cancel, QtWidgets.QDialogButtonBox.Help
        return sum(map(flags_as_int, buttons))

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
        self._nodes = self._proposal = self._check = self._shell = None
        self._covered, self._views = CoveredSources(), Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        self._sizes, self._fem_missing, self._gmsh_missing = {}, missing_fem(), ""
        self._is_accepted = self._has_left = self._asks_shell = False
        self._form.changed.connect(self._change)
        self._form.walls.edited.connect(self._edit)
        self._form.walls.faces_chosen.connect(self._select_faces)
        self._form.mesh_requested.connect(self._mesh)
        self._form.shell.shell_requested.connect(self._mesh)
        self._form.shell.faces_chosen.connect(self._select_faces)
        self._form.shell_changed.connect(self._change_shell)
        self._form.kind_changed.connect(self._change_kind)
        self._form.cancelled.connect(self._cancel)
        self._form.shown_changed.connect(self._show_in_view)
        self.measured.progressed.connect(self._on_progress)
        self.measured.measured.connect(self._on_measured)
        self.measured.proposed.connect(self._on_proposed)
        self.measured.meshed.connect(self._on_meshed)
        self.measured.shelled.connect(self._on_shelled)
        self.measured.refused.connect(self._on_refused)
        self.measured.ended.connect(self._on_failed)
        self.panel.closed.connect(self._leave)
        self._offer = self._offer_request = None
        self._form.offer_taken.connect(self._use_offer)
        lifelong.requests.answered.connect(self._on_offer)
        lifelong.region_notes.answered.connect(self._on_notes)
        lifelong.units.changed.connect(self._show_unit)
        self._views.subWindowActivated.connect(self._on_view)
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
            self._form.show_part(document.FileName, self._part.name, self._part.label, length_unit(document))
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
            lifelong.requests.answered.disconnect(self._on_offer)
            lifelong.units.changed.disconnect(self._show_unit)
            self._views.subWindowActivated.disconnect(self._on_view)
            self._clear_view()
            self.measured.end()

    def _on_measured(self, found):
        self._record, self._gmsh_missing = found["record"], translated(found["gmsh"]) if found["gmsh"] else ""
        if self._proposal is None:
            self._form.shell.show_walls(found["shell_walls"])
            self._take_over_notes()
            self._offer_request = lifelong.requests.ask(
                "document_info.settings_for", record=self._record, document=self._document.FileName)
        self._show_missing()
        if self._proposal is None:
            self._form.show_running(translate("ThinPart", "Finding element sizes for {}").format(self._part.label), 1.0)
        else:
            self._form.show_idle(not self._gmsh_missing)
        self._ask()

    def _on_offer(self, request):
        """Settings that worked for this part or for one like it."""
        offer = request.answer
        if request is not self._offer_request or offer is None:
            return
        self._offer, meshed = offer, offer["meshed"]
        if offer["is_own"]:
            text = translate("ThinPart", "Settings that worked for this part: {}").format(self._made(meshed))
        else:
            text = translate("ThinPart", "Settings that worked for {} ({} alike): {}").format(
                offer["label"], percent(offer["alike"] / 100.0), self._made(meshed))
        self._form.show_offer(text)

    def _made(self, meshed):
        return translate("ThinPart", "layers: {}, elements: {}").format(
            f"{meshed['layers'] or LAYERS_OF_ORDER[meshed['order']]:g}", grouped(meshed["elements"]))

    def _use_offer(self):
        settings = self._offer["settings"]
        layers = settings["layers"] or LAYERS_OF_ORDER[settings["order"]]
        self._sizes.update(map(tuple, self._offer["sizes"]))
        self._form.show_settings({**settings, "layers": layers})
        self._form.show_offer("")

    def _show_missing(self):
        self._form.show_message("\n".join(filter(None, [self._gmsh_missing, translated(self._fem_missing)])))

    def _on_notes(self, document, _sentence):
        if document == self._document.FileName and self._record is not None and not self._is_edited:
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

    def _change_shell(self):
        self._shell = None
        self._form.shell.show_shell(None, None)
        self._show_in_view()

    def _change_kind(self):
        self._show_missing()
        self._show_in_view()

    def _show_unit(self):
        """Another unit system was chosen while the panel is open."""
        if self._part is not None:
            self._form.show_part(self._document.FileName, self._part.name, self._part.label, length_unit(self._document))
            if self._proposal is not None:
                self._show_proposal()
            if self._shell is not None:
                self._form.shell.show_shell(self._shell, self._thickness_scale())

    def _on_progress(self, done):
        stage = (translate("ThinPart", "Making the mid-surface of {}") if self.measured.is_meshing
                 else translate("ThinPart", "Measuring the walls of {}"))
        self._form.show_running(stage.format(self._part.label), done)

    def _on_proposed(self, found):
        if self._proposal is None:
            self._form.show_idle(not self._gmsh_missing)
        self._proposal = found
        self._show_proposal()
        self._show_in_view()

    def _show_proposal(self):
        found, scale = self._proposal, self._scale()
        colours = [tuple(scale.colours([row["size"] or found["global_size"]])[0] / 255.0) for row in found["regions"]]
        self._form.show_proposal(found, colours, scale if self._has_sizes else None)

    @property
    def _has_sizes(self):
        """Whether the proposal has more than one size."""
        return self._proposal["least_size"] < self._proposal["global_size"]

    def _scale(self):
        largest = self._proposal["global_size"]
        # Where all elements are as large as that, they have the colour of the largest ones.
        return ColourScale(self._proposal["least_size"] if self._has_sizes else 0.5 * largest, largest, logarithmic=True)

    def _thickness_scale(self):
        thick = [wall["thickness"] for wall in self._shell["walls"]]
        if max(thick) <= ALIKE * min(thick):
            return ColourScale(0.5 * min(thick), 1.5 * max(thick))  # one colour, whatever the last digits are
        return ColourScale(min(thick), max(thick))

    def _mesh(self):
        if self._gmsh_missing or self._record is None:
            return
        self._form.show_message("")
        if not self.measured.is_ready:
            self.measured.restart()  # its process has ended, of whatever; the request waits until the part is measured
        self._asks_shell = self._form.is_shell
        if self._asks_shell:
            self._form.show_running(translate("ThinPart", "Making the mid-surface of {}").format(self._part.label), 0.0)
            self.measured.shell(self._form.shell.settings())
        else:
            self._form.show_running(translate("ThinPart", "Gmsh meshes {}").format(self._part.label), 0.0)
            self.measured.mesh(*self._request())

    def _cancel(self):
        """Stop Gmsh or measuring; a part that was measured is measured again, for further changes."""
        was_meshing, self._is_accepted = self.measured.is_meshing, False
        if was_meshing:
            self.measured.restart()
            self._form.show_running(translate("ThinPart", "Measuring the walls of {}").format(self._part.label))
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

    def _on_shelled(self, found):
        self._form.show_idle(True)
        self._shell = found
        self._form.shell.show_shell(found, self._thickness_scale())
        self._show_in_view()
        if self._is_accepted:
            self._make()

    def _on_refused(self, sentence):
        was_shell, self._asks_shell = self._asks_shell, False
        self._on_failed(sentence)
        if was_shell:
            self._ask()  # the advice knows now whether there is a shell

    def _on_failed(self, sentence):
        self._is_accepted = False
        self._form.show_idle(self._record is not None and not self._gmsh_missing)
        self._form.show_message(sentence)

    def _accept(self):
        sentence = translated(self._fem_missing) or self._gmsh_missing
        if sentence or self._record is None:
            if sentence:
                self._form.show_message(sentence)
            return
        self._is_accepted = True
        if self._shell is not None if self._form.is_shell else self._check is not None and self._check["mesh"]:
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
        try:
            with transaction(document, translate("ThinPart", "Prepare mesh")):
                self._set_shell() if self._form.is_shell else self._set_mesh()
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        if document.FileName and not self._form.is_shell:
            self._keep_settings()
        QtCore.QTimer.singleShot(0, self.close)

    def _keep_settings(self):
        """Keep the settings that worked with the part, for it and for parts like it."""
        settings, sizes = self._request()
        chosen = dict(sizes)
        rows = [{"kind": row["kind"], "thickness": row["thickness"], "size": row["size"],
                 "is_changed": row["region"] in chosen} for row in self._check["regions"]]
        lifelong.requests.keep(
            "document_info.keep_settings", document=self._document.FileName, part=self._record["name"],
            settings=settings, rows=rows, global_size=self._check["global_size"],
            diagonal=self._record["descriptors"]["diagonal_mm"], figures={key: self._check["proposed"][key] for key in (
                "elements", "poor_share", "gamma_least", "layers_share", "tries")})

    def _set_mesh(self):
        unit, (settings, sizes) = length_unit(self._document), self._request()
        walls = [(translate("ThinPart", "{} of {}: elements of {}").format(
            kind_word(row["kind"]), unit.text(row["thickness"]), unit.text(row["size"])), row["size"],
            [self._faces[face] for face in row["faces"]]) for row in self._check["regions"] if row["size"] is not None]
        set_fem_mesh(self._document, self._owner, self._check["mesh"], {**settings, "walls": sizes},
                     self._check["global_size"], settings["order"], walls, active_analysis(self._document))

    def _set_shell(self):
        unit, settings, found = length_unit(self._document), self._form.shell.settings(), self._shell
        thicknesses = [(translate("ThinPart", "{} thick").format(unit.text(group["thickness"])), group["thickness"],
                        group["faces"]) for group in found["groups"]]
        labels = tuple(text.format(self._owner.Label) for text in (
            translate("ThinPart", "{} mid-surface"), translate("ThinPart", "{} shell mesh")))
        set_fem_shell(self._document, self._owner, labels, self.measured.file(SHELL_SHAPE), self.measured.file(SHELL_MESH),
                      settings, found["size"], settings["order"], thicknesses, active_analysis(self._document))

    def _select_faces(self, faces):
        if not self._has_left:
            select_faces(self._document, self._whole, faces)

    def _on_view(self, *_):
        # A view that was just made is in the list of the document's views a moment later.
        QtCore.QTimer.singleShot(0, self._show_in_new_views)

    def _show_in_new_views(self):
        if self._nodes is not None and not self._has_left:
            self._nodes.show_in(self._scenes())

    def _show_in_view(self):
        """Show sizes and poor elements, or the shell, as the panel says."""
        if self._proposal is None or self.measured.folder is None or self._has_left:
            return
        if self._nodes is None:
            self._nodes = SizeNodes(motion(self._part.shape, self._whole.shape))
        nodes, form = self._nodes, self._form
        nodes.show_in(self._scenes())
        shows_shell = form.is_shell and self._shell is not None and form.shell.preview.isChecked()
        if shows_shell:
            corners, thickness = (np.load(self.measured.file(name)) for name in (SHELL_FACETS, SHELL_THICKNESS))
            colours = self._thickness_scale().colours(thickness)
            nodes.show_sizes(corners, np.repeat(colours[:, None], 3, axis=1), has_edges=True)
        elif not form.is_shell and form.preview.isChecked():
            corners, sizes = (np.load(self.measured.file(name)) for name in (FACETS, SIZES))
            nodes.show_sizes(corners, self._scale().colours(sizes.ravel()).reshape(-1, 3, 3))
        else:
            nodes.hide_sizes()
        self._covered.cover(self._covering() if shows_shell else set())
        # A colour bar of thicknesses beside colours of sizes would be read as theirs.
        is_coloured = shows_shell or not form.is_shell and form.preview.isChecked()
        lifelong.map_events.set_maps_aside(self.measured.name, shows_shell if is_coloured else None)
        if self._check is not None and form.poor.isChecked() and not form.is_shell:
            nodes.show_poor(np.load(self.measured.file(POOR)))
        else:
            nodes.hide_poor()

    def _covering(self):
        """The objects that hide the shell of the part: document and name."""
        occurrence = self._part.occurrences[0]
        leaf = object_at(occurrence.top(self._document), occurrence.path)
        return {(each.Document.Name, each.Name) for each in (leaf, self._owner)}

    def _scenes(self):
        try:
            shown = Gui.getDocument(self.measured.name)
        except NameError:
            return []  # the document is being closed, and its views with it
        return [view.getSceneGraph() for view in shown.mdiViewsOfType("Gui::View3DInventor")]

    def _clear_view(self):
        nodes, self._nodes = self._nodes, None
        self._covered.cover(set())
        lifelong.map_events.set_maps_aside(self.measured.name, None)
        if nodes is not None:
            nodes.leave(self._scenes())
