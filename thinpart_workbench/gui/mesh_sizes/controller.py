# SPDX-License-Identifier: LGPL-2.1-or-later
"""Controls the preparation of a mesh: from the selected part to its FEM mesh."""

import FreeCADGui as Gui

from ...api.window.open_parts import parts_selected
from ...api.window.part_sizes import poor_elements, shell_files, shown_shell, shown_sizes, shown_thickness_range
from ...api.window.part_to_mesh import PartToMesh
from ...api.window.profiles import preferred_profile
from ...core.errors import ThinPartError
from ...core.rendering.colour_scale import ColourScale
from ...freecad_adapter.objects.fem_mesh import missing_fem
from ...freecad_adapter.preferences import preferred_analysis
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, flags_as_int, translate
from ..application.sentences import translated
from ..document.part_chooser import ask_for_part
from ..document.selection import active_path, select_faces, selected_paths
from ..document.task_controller import MeasuringController
from ..document.task_dialog import TaskDialog
from ..document.transaction import transaction
from ..processes.size_client import SizeClient
from ..record.regions_table import counted_kind
from .active_analysis import analysis_to_join
from .panel import MeshSizesPanel
from .size_view import SizeView
from .wall_sizes import WallSizes
from .worked_settings import WorkedSettings


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
        if self.is_put_away:
            self.come_to_front()
        else:
            self._accept()
        return False


class MeshSizesController(MeasuringController):
    """Proposes element sizes for one part of a document, has it meshed, and makes its FEM mesh."""

    def __init__(self, document):
        super().__init__()
        self._document = document
        self.measured = SizeClient(document, self)
        self._form = MeshSizesPanel()
        self.panel = MeshDialog(self._form, self._accept)
        self._part = self._record = self._view = None
        self._proposal = self._check = self._shell = None
        self._fem_missing, self._gmsh_missing = missing_fem(), ""
        self._is_accepted = self._has_left = self._asks_shell = False
        self._walls, self._worked = WallSizes(document, self), WorkedSettings(document, self)
        self._walls.noted.connect(self._ask)
        self._worked.found.connect(self._form.show_offer)
        self._form.offer_taken.connect(self._use_offer)
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
        lifelong.units.changed.connect(self._show_unit)

    def start(self):
        """Find the part, open the panel and measure."""
        try:
            document = self._document
            parts = parts_selected(document, selected_paths(document), active_path(document))
            whole = parts[0] if len(parts) == 1 else ask_for_part(parts, Gui.getMainWindow())
            if whole is None:
                return
            self._part = PartToMesh.of(document, whole)
            self._view = SizeView(self._part, self)
            profile = preferred_profile().content
            self._walls.read_notes()
            self.panel.show()
            self._form.show_part(document.FileName, self._part.part.name, self._label, length_unit(document))
            self._form.show_running(translate("ThinPart", "Starting to measure {}").format(self._label))
            self.measured.start(self._part.part, preferred_analysis(), profile)
        except ThinPartError as error:
            if not self.panel.is_open:
                self.panel.show()
            self._form.show_idle(False)
            self._form.show_message(translated(error))

    @property
    def _label(self):
        return self._part.part.label

    def _leave(self):
        if not self._has_left:
            self._has_left = True
            self._walls.leave()
            self._worked.leave()
            lifelong.units.changed.disconnect(self._show_unit)
            if self._view is not None:
                self._view.leave()
            self.measured.end()

    def _on_measured(self, found):
        self._record, self._gmsh_missing = found["record"], translated(found["gmsh"]) if found["gmsh"] else ""
        if self._proposal is None:
            self._form.shell.show_walls(found["shell_walls"])
            self._walls.show_record(self._record)
            self._worked.look_for(self._record)
        self._show_missing()
        if self._proposal is None:
            self._form.show_running(translate("ThinPart", "Finding element sizes for {}").format(self._label), 1.0)
        else:
            self._form.show_idle(not self._gmsh_missing)
        self._ask()

    def _use_offer(self):
        settings, sizes = self._worked.offered()
        self._walls.take_over(sizes)
        self._form.show_settings(settings)
        self._form.show_offer("")

    def _show_missing(self):
        self._form.show_message("\n".join(filter(None, [self._gmsh_missing, translated(self._fem_missing)])))

    def _request(self):
        return self._form.settings(), self._walls.wanted()

    def _change(self):
        self._check = None
        self._form.show_check(None)
        self._show_in_view()
        self._ask()

    def _ask(self):
        if self._record is not None and not self.measured.is_meshing:
            self.measured.ask(*self._request())

    def _edit(self, sizes):
        self._walls.type(sizes)
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
            self._form.show_part(self._document.FileName, self._part.part.name, self._label, length_unit(self._document))
            if self._proposal is not None:
                self._show_proposal()
            if self._shell is not None:
                self._form.shell.show_shell(self._shell, _thickness_scale(self._shell))

    def _on_progress(self, done):
        stage = (translate("ThinPart", "Making the mid-surface of {}") if self.measured.is_meshing
                 else translate("ThinPart", "Measuring the walls of {}"))
        self._form.show_running(stage.format(self._label), done)

    def _on_proposed(self, found):
        if self._proposal is None:
            self._form.show_idle(not self._gmsh_missing)
        self._proposal = found
        self._show_proposal()
        self._show_in_view()

    def _show_proposal(self):
        found, scale = self._proposal, _size_scale(self._proposal)
        colours = [tuple(scale.colours([row["size"] or found["global_size"]])[0] / 255.0) for row in found["regions"]]
        self._form.show_proposal(found, colours, scale if _has_sizes(found) else None)

    def _mesh(self):
        if self._gmsh_missing or self._record is None:
            return
        self._form.show_message("")
        if not self.measured.is_ready:
            self.measured.restart()  # its process has ended, of whatever; the request waits until the part is measured
        self._asks_shell = self._form.is_shell
        if self._asks_shell:
            self._form.show_running(translate("ThinPart", "Making the mid-surface of {}").format(self._label), 0.0)
            self.measured.shell(self._form.shell.settings())
        else:
            self._form.show_running(translate("ThinPart", "Gmsh meshes {}").format(self._label), 0.0)
            self.measured.mesh(*self._request())

    def _cancel(self):
        """Stop Gmsh or measuring; a part that was measured is measured again, for further changes."""
        was_meshing, self._is_accepted = self.measured.is_meshing, False
        if was_meshing:
            self.measured.restart()
            self._form.show_running(translate("ThinPart", "Measuring the walls of {}").format(self._label))
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
                "ThinPart", "Gmsh made no mesh ({}): try another error or fewer layers, a smaller largest size, or switch a "
                            "wall off. Nothing was changed.").format(translated(found["proposed"]["reason"])))
        elif self._is_accepted:
            self._make()

    def _on_shelled(self, found):
        self._form.show_idle(True)
        self._shell = found
        self._form.shell.show_shell(found, _thickness_scale(found))
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
        if not self._part.is_unchanged:
            self._form.show_message(translate(
                "ThinPart", "The document has changed while it was meshed: start again. Nothing was changed."))
            return
        try:
            with transaction(self._document, translate("ThinPart", "Prepare mesh")):
                self._set_shell() if self._form.is_shell else self._set_mesh()
        except ThinPartError as error:
            self._form.show_message(translated(error))
            return
        if not self._form.is_shell:
            self._worked.keep(self._record, *self._request(), self._check)
        QtCore.QTimer.singleShot(0, self.close)

    def _set_mesh(self):
        unit = length_unit(self._document)

        def label(row):
            return translate("ThinPart", "{} of {}: elements of {}").format(
                counted_kind(row["word"], row["count"]), unit.text(row["thickness"]), unit.text(row["size"]))

        self._part.set_mesh(self._check, *self._request(), label,
                            analysis_to_join(self._document, self._part.owner, self._form.makes_analysis))

    def _set_shell(self):
        unit = length_unit(self._document)
        labels = tuple(text.format(self._part.owner.Label) for text in (
            translate("ThinPart", "{} mid-surface"), translate("ThinPart", "{} shell mesh")))
        self._part.set_shell(
            self._shell, shell_files(self.measured.folder), self._form.shell.settings(), labels,
            lambda thickness: translate("ThinPart", "{} thick").format(unit.text(thickness)),
            analysis_to_join(self._document, self._part.owner, self._form.makes_analysis))

    def _select_faces(self, faces):
        if not self._has_left:
            select_faces(self._document, self._part.whole, faces)

    def _show_in_view(self):
        """Show sizes and poor elements, or the shell, as the panel says."""
        if self._proposal is None or self.measured.folder is None or self._has_left:
            return
        form, folder = self._form, self.measured.folder
        if form.is_shell and self._shell is not None and form.shell.preview.isChecked():
            corners, thickness = shown_shell(folder)
            self._view.show_shell(corners, _thickness_scale(self._shell).colours(thickness))
        elif not form.is_shell and form.preview.isChecked():
            corners, sizes, normals = shown_sizes(folder)
            self._view.show_sizes(
                corners, _size_scale(self._proposal).colours(sizes.ravel()).reshape(-1, 3, 3), normals)
        else:
            self._view.hide()
        shows_poor = self._check is not None and form.poor.isChecked() and not form.is_shell
        self._view.show_poor(poor_elements(folder) if shows_poor else ())


def _has_sizes(proposal):
    """Whether a proposal has more than one size."""
    return proposal["least_size"] < proposal["global_size"]


def _size_scale(proposal):
    largest = proposal["global_size"]
    # Where all elements are as large as that, they have the colour of the largest ones.
    return ColourScale(proposal["least_size"] if _has_sizes(proposal) else 0.5 * largest, largest, logarithmic=True)


def _thickness_scale(shell):
    return ColourScale(*shown_thickness_range([wall["thickness"] for wall in shell["walls"]]))
