# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that prepares a mesh: settings, walls with their sizes, the estimate, and what Gmsh makes of them."""

from ...core.sizing.sizing_settings import LAYERS_OF_ORDER, MOST_ERROR, SizingSettings
from ..application.icons import icon
from ..application.length_unit import MILLIMETRE
from ..application.numbers import marked, number, percent
from ..application.qt import QtWidgets, Signal, blocked, grouped, named, translate
from ..application.sentences import translated
from ..record.kept_room import keep_room
from ..record.measuring_progress import MeasuringProgress
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from .mesh_fields import number_field, order_combo
from .quality_chart import QualityChart
from .scale_bar import ScaleBar
from .shell_box import ShellBox
from .wall_table import WallSizesTable

AIM = SizingSettings.error

ERRORS = (0.01, AIM, 0.05, 0.1)
"""Errors that can be aimed at; below them stands the choice of layers."""


class MeshSizesPanel(QtWidgets.QWidget):
    """The widgets, without logic.

    Signals
    -------
    changed, shell_changed
        A setting was changed, of the solid mesh or of the shell.
    kind_changed
        The user has chosen between solid and shell: see `is_shell`.
    mesh_requested, cancelled, shown_changed, offer_taken
        A button was pressed; what the view is to show was changed; the settings that are offered are to be used.
    """

    changed = Signal()
    shell_changed = Signal()
    kind_changed = Signal()
    mesh_requested = Signal()
    cancelled = Signal()
    shown_changed = Signal()
    offer_taken = Signal()

    def __init__(self):
        super().__init__()
        self.setObjectName("ThinPart_MeshSizesPanel")
        self.setWindowTitle(translate("ThinPart", "Prepare mesh"))
        self.setWindowIcon(icon("ThinPart_MeshSizes"))
        self._unit = MILLIMETRE
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._part = text_line(self, column, "ThinPart_MeshPart")
        self._progress = MeasuringProgress(self)
        self._progress.cancelled.connect(self.cancelled)
        column.addWidget(self._progress)
        self._content = QtWidgets.QWidget(self)
        column.addWidget(self._content)
        rows = QtWidgets.QVBoxLayout(self._content)
        rows.setContentsMargins(0, 0, 0, 0)
        self._add_kind(rows)
        self._analysis = named(QtWidgets.QCheckBox(translate(
            "ThinPart", "OK also makes an analysis, if there is none"), self), "ThinPart_MakeAnalysis")
        self._analysis.setToolTip(translate("ThinPart", "With CalculiX as its solver, and steel, which you replace. "
                                                        "Supports and loads are yours to add."))
        self._analysis.setChecked(True)
        rows.addWidget(self._analysis)
        self.shell = ShellBox(self)
        self.shell.changed.connect(self.shell_changed)
        self.shell.shown_changed.connect(self.shown_changed)
        rows.addWidget(self.shell)
        self._solid = QtWidgets.QWidget(self)
        rows.addWidget(self._solid)
        rows = QtWidgets.QVBoxLayout(self._solid)
        rows.setContentsMargins(0, 0, 0, 0)
        self._add_settings(rows)
        self.walls = WallSizesTable(self)
        rows.addWidget(self.walls)
        self.preview = self._check(rows, "ThinPart_SizePreview", translate("ThinPart", "Show sizes on the part"), True)
        self._legend = ScaleBar("ThinPart_SizeBar", self)
        rows.addWidget(self._legend)
        self._mesh = add_button(rows, self, "ThinPart_MeshButton", translate("ThinPart", "Mesh and compare"),
                                self.mesh_requested.emit)
        self._estimate = text_line(self, rows, "ThinPart_MeshEstimate")
        self._take_offer = add_button(rows, self, "ThinPart_UseMeshSettings", translate("ThinPart", "Use these settings"),
                                      self.offer_taken.emit)
        self._offer = text_line(self, rows, "ThinPart_MeshOffer")
        self.show_offer("")
        self._figures = text_line(self, rows, "ThinPart_MeshFigures")
        self.chart = QualityChart(self)
        rows.addWidget(self.chart)
        self.poor = self._check(rows, "ThinPart_PoorElements", "", True)
        self.message = text_line(self, column, "ThinPart_Message")
        column.addStretch(1)
        self.show_message("")
        self.show_check(None)
        self._show_kind()
        self._content.hide()
        self._progress.hide()

    @property
    def is_shell(self):
        """Whether a shell is wanted, not a solid mesh."""
        return self._kind.currentIndex() == 1

    @property
    def makes_analysis(self):
        """Whether an analysis is to be made where the document has none."""
        return self._analysis.isChecked()

    def settings(self):
        """The fields as arguments of `SizingSettings`: dict."""
        size, budget = self._size.exact(), self._budget.value()
        error = self._aim.currentData()
        return {"order": 1 + self._order.currentIndex(), "error": error, "growth": self._growth.exact(),
                "layers": self._layers.exact() if error is None else None, "size": size if size > 0.0 else None,
                "budget": budget or None}

    def show_settings(self, settings):
        """Show settings in the fields: as of `settings`."""
        with blocked(self):
            self._order.setCurrentIndex(settings["order"] - 1)
            self._show_aim(None if settings["layers"] is not None or settings["order"] == 1 else settings["error"])
            # After the order, which changes them too.
            self._layers.show_exact(settings["layers"] or LAYERS_OF_ORDER[settings["order"]])
            self._growth.show_exact(settings["growth"])
            self._size.show_exact(settings["size"] or 0.0)
            self._budget.setValue(settings["budget"] or 0)
        self.changed.emit()

    def show_offer(self, sentence):
        """Show which settings are offered; an empty text for none."""
        show_text(self._offer, sentence)
        self._take_offer.setVisible(bool(sentence))

    def show_part(self, file, name, label, unit):
        """Show which part it is about: its document, name and label, and in which unit lengths are."""
        show_text(self._part, label)
        self.walls.subject = self.shell.walls.subject = file, name, label
        self._unit = unit
        self._size.set_form(1.0 / unit.millimetres, "\u00a0" + unit.symbol, unit.decimals, 0.0)
        self.shell.show_unit(unit)

    def show_message(self, sentence):
        """Show a sentence."""
        show_text(self.message, sentence)

    def show_running(self, stage, fraction=0.0):
        """Show what is being done."""
        self._progress.show()
        self._progress.show_progress(fraction, stage)
        self._content.setEnabled(False)  # what is meshed is what the fields say
        self._set_buttons(False)

    def show_idle(self, can_mesh):
        """Show that nothing is being done."""
        self._progress.hide()
        self._content.setEnabled(True)
        self._set_buttons(can_mesh)

    def show_proposal(self, found, colours, scale):
        """Show what is proposed: see `PartSizing.proposed`; with a colour for each row, and the ColourScale of sizes."""
        unit = self._unit
        self._content.show()
        keep_room(self._progress)  # from now on every change of a setting is worked out
        self.walls.show_walls(found["regions"], unit, colours)
        self.walls.setVisible(bool(found["regions"]))
        if not self._size.exact():
            self._size.setSpecialValueText(translate("ThinPart", "automatic: {}").format(unit.text(found["global_size"])))
        lines = [self._sizes(found)]
        if found["left_out"] and found["least_size"] >= found["global_size"]:
            lines = [translate("ThinPart", "A normal part: one size is enough. About {} elements of {}. Tick a wall to give "
                                           "it layers.").format(grouped(_rounded(found["elements"])),
                                                                unit.text(found["global_size"]))]
        if not found["regions"] and found["error"] is None:
            lines = [translate("ThinPart", "No thin walls: one size is enough. About {} elements of {}.").format(
                grouped(_rounded(found["elements"])), unit.text(found["global_size"]))]
        elif found["error"] is None and found["least_size"] < found["global_size"]:
            lines.append(translate("ThinPart", "The smallest size everywhere would take {}.").format(
                grouped(_rounded(found["uniform_elements"]))))
        if found["unbounded_elements"] is not None and found["error"] is not None:
            lines.append(translate("ThinPart", "The limit costs accuracy: {} would take about {} elements.").format(
                _percent(found["wanted_error"]), grouped(_rounded(found["unbounded_elements"]))))
        elif found["unbounded_elements"] is not None:
            lines.append(translate(
                "ThinPart", "The limit costs layers: {} instead of {}, which would take about {} elements.").format(
                    marked(f"{found['layers']:.2g}"), marked(f"{found['wanted_layers']:.2g}"),
                    grouped(_rounded(found["unbounded_elements"]))) if found["layers"] < found["wanted_layers"] else
                translate("ThinPart", "The limit costs layers: all walls would take about {} elements.").format(
                    grouped(_rounded(found["unbounded_elements"]))))
        if found["layered_from"]:
            lines.append(translate("ThinPart", "Walls under {} have fewer layers: they would take most of the elements.")
                         .format(unit.text(found["layered_from"])))
        show_text(self._estimate, " ".join(self._many(found) + lines))
        show_text(self._advice, idealisation_text(found["idealisation"]))
        self._legend.show_scale(scale, unit)

    def show_check(self, found):
        """Show what Gmsh made, see `PartSizing.mesh`; None for nothing."""
        self.chart.setVisible(found is not None)
        self.poor.setVisible(found is not None and found["poor_count"] > 0)
        if found is None:
            show_text(self._figures, "")
            return
        has_layers = self._aim.currentData() is None  # else one is enough, and every wall has it
        lines = [translate("ThinPart", "One size: {}").format(_figures(found["default"], has_layers)),
                 translate("ThinPart", "As proposed: {}").format(_figures(found["proposed"], has_layers))]
        tries = found["proposed"]["tries"]
        if len(tries) > 1:
            lines.append(translate("ThinPart", "Try {}: {}").format(len(tries), translated(tries[-1]["what"])))
        show_text(self._figures, "\n".join(lines))
        self.chart.show_histograms(found["default"]["histogram"], found["proposed"]["histogram"])
        self.poor.setText(translate("ThinPart", "Show poor elements ({})").format(grouped(found["poor_count"])))

    @staticmethod
    def _many(found):
        """A sentence first where the mesh is larger than most are, and what to do: list of str."""
        if not found["is_large"]:
            return []
        lines = [translate("ThinPart", "About {} nodes: more than most analyses need.").format(
            grouped(_rounded(found["nodes"]))),
            translate("ThinPart", "Set \"Most elements\", or fewer layers.") if found["error"] is None else
            translate("ThinPart", "Set \"Most elements\", or a larger error.")]
        if found["idealisation"]["shell_elements"]:
            lines.append(translate("ThinPart", "A shell would take about {} triangles.").format(
                grouped(_rounded(found["idealisation"]["shell_elements"]))))
        return lines

    def _sizes(self, found):
        unit = self._unit
        counts = grouped(_rounded(found["nodes"])), grouped(_rounded(found["elements"]))
        sizes = unit.number(found["least_size"]), unit.text(found["global_size"])
        if found["error"] is None:
            return translate("ThinPart", "About {} nodes ({} elements), of {} to {}.").format(*counts, *sizes)
        return translate("ThinPart", "About {} nodes ({} elements), of {} to {}, for an error of {} in deflections and "
                                     "frequencies. CalculiX takes about {} s for six frequencies.").format(
            *counts, *sizes, _percent(found["error"]), grouped(max(1, round(found["solver_seconds"]))))

    def _add_kind(self, rows):
        form = QtWidgets.QFormLayout()
        rows.addLayout(form)
        self._kind = named(QtWidgets.QComboBox(self), "ThinPart_MeshKind")
        self._kind.addItems([translate("ThinPart", "Solid"), translate("ThinPart", "Shell: its mid-surface")])
        form.addRow(translate("ThinPart", "Mesh as"), self._kind)
        self._advice = text_line(self, rows, "ThinPart_MeshAdvice")
        keep_room(self._advice, 4)
        self._kind.currentIndexChanged.connect(lambda *_: (self._show_kind(), self.kind_changed.emit()))

    def _show_kind(self):
        self.shell.setVisible(self.is_shell)
        self._solid.setVisible(not self.is_shell)

    def _set_buttons(self, is_enabled):
        for button in (self._mesh, self.shell.button):
            button.setEnabled(is_enabled)

    def _add_settings(self, rows):
        form = QtWidgets.QFormLayout()
        form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
        rows.addLayout(form)
        self._aim = named(QtWidgets.QComboBox(self), "ThinPart_MeshAim")
        for error in ERRORS:
            self._aim.addItem(_percent(error), error)
        self._aim.addItem(translate("ThinPart", "layers instead"), None)
        self._aim.setToolTip(translate("ThinPart", "Of deflections and frequencies, with quadratic elements. It decides the "
                                                   "sizes."))
        self._order = order_combo("ThinPart_MeshOrder", self)
        self._order.setCurrentIndex(SizingSettings.order - 1)
        self._order.setToolTip(translate("ThinPart", "Linear elements are far too stiff in thin walls."))
        self._layers = self._field("ThinPart_MeshLayers", 2.0, 0.1, 20.0)
        self._size = self._field("ThinPart_MeshSize", 0.0, 0.0, 1e6)
        self._growth = self._field("ThinPart_MeshGrowth", SizingSettings.growth, 1.05, 3.0)
        self._budget = named(QtWidgets.QSpinBox(self), "ThinPart_MeshBudget")
        self._budget.setRange(0, 100_000_000)
        self._budget.setSingleStep(10_000)
        self._budget.setKeyboardTracking(False)
        self._budget.setSpecialValueText(translate("ThinPart", "no limit"))
        for text, field in ((translate("ThinPart", "Error aimed at"), self._aim),
                            (translate("ThinPart", "Elements"), self._order),
                            (translate("ThinPart", "Layers in thin walls"), self._layers),
                            (translate("ThinPart", "Largest size"), self._size),
                            (translate("ThinPart", "Growth"), self._growth),
                            (translate("ThinPart", "Most elements"), self._budget)):
            form.addRow(text, field)
        self._show_aim(AIM)
        self._order.currentIndexChanged.connect(self._on_order)
        self._aim.currentIndexChanged.connect(self._on_aim)
        self._budget.valueChanged.connect(lambda *_: self.changed.emit())

    def _on_order(self, *_):
        # One quadratic element through a wall bends as well as two linear ones.
        order = 1 + self._order.currentIndex()
        self._layers.show_exact(LAYERS_OF_ORDER[order])
        if order == 1 or self._aim.currentData() is None:
            with blocked(self):
                self._show_aim(AIM if order == 2 else None)
        self.changed.emit()

    def _on_aim(self, *_):
        self._layers.setEnabled(self._aim.currentData() is None)
        if self._aim.currentData() is not None and self._order.currentIndex() == 0:
            self._order.setCurrentIndex(1)  # which says that it changed, and keeps the error
            return
        self.changed.emit()

    def _show_aim(self, error):
        """Show an error, one of others too, or None for layers."""
        row = next((row for row in range(self._aim.count()) if self._aim.itemData(row) == error), -1)
        if row < 0:
            row = self._aim.count() - 1
            self._aim.insertItem(row, _percent(error), error)
        self._aim.setCurrentIndex(row)
        self._layers.setEnabled(error is None)

    def _field(self, name, value, least, most):
        field = number_field(name, self, value, least, most)
        field.changed.connect(self.changed)
        return field

    def _check(self, rows, name, text, is_on):
        box = named(QtWidgets.QCheckBox(text, self), name)
        box.setChecked(is_on)
        box.toggled.connect(lambda *_: self.shown_changed.emit())
        rows.addWidget(box)
        return box


def idealisation_text(found):
    """Whether a part is better a shell or a solid, with the figures for both: str; see `core.shells.shell_or_solid`."""
    advice = {"shell": translate("ThinPart", "Recommended: shell."),
              "mixed": translate("ThinPart", "Recommended: solid, or a shell of its walls only."),
              "solid": translate("ThinPart", "Recommended: solid.")}[found["advice"]]
    lines = [advice]
    if found["plate_volume_share"] is not None and found["width_to_thickness"] is not None:
        lines.append(translate("ThinPart", "{} of the volume in plate-like walls, {} times as wide as thick.").format(
            percent(found["plate_volume_share"]), number(found["width_to_thickness"])))
    counts = grouped(_rounded(found["solid_elements"])), grouped(_rounded(found["shell_elements"]))
    lines.append(translate("ThinPart", "About {} elements as a solid, {} as a shell.").format(*counts)
                 if found["shell_elements"] else translate("ThinPart", "About {} elements as a solid.").format(counts[0]))
    if found["no_shell"]:
        lines.append(translated(found["no_shell"]))
    return " ".join(lines)


def _figures(figures, has_layers):
    if not figures["elements"]:
        return translate("ThinPart", "no mesh ({})").format(translated(figures["reason"]))
    text = translate("ThinPart", "{} elements, {} poor, worst {}").format(
        grouped(figures["elements"]), marked(f"{100.0 * figures['poor_share']:.2g}\u00a0%"),
        marked(f"{figures['gamma_least']:.2g}"))
    if has_layers and figures["layers_share"] is not None:
        text += translate("ThinPart", ", layers in {} of the thin walls").format(percent(figures["layers_share"]))
    return text


def _percent(share):
    if share > MOST_ERROR:
        return translate("ThinPart", "more than {}").format(percent(MOST_ERROR))
    return marked(f"{100.0 * share:.2g}\u00a0%")


def _rounded(count):
    return int(float(f"{count:.3g}"))
