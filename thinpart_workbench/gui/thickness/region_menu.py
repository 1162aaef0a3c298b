# SPDX-License-Identifier: LGPL-2.1-or-later
"""The context menu of a wall region."""

from ..application.qt import QtWidgets, translate


class RegionMenu(QtWidgets.QMenu):
    """What can be done with a row of regions, and the questions that go with it.

    Parameters
    ----------
    group : RegionGroup
    refusal : str
        Why nothing can be kept of the regions; empty if it can.
    is_isolated : bool
        Whether the map shows only some walls now.
    act : callable
        Called with one of "isolate", "show_all", "excluded" and "mesh_size_mm", and the new value of the latter two.
    """

    def __init__(self, group, unit, refusal, is_isolated, act, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_RegionMenu")
        self.setToolTipsVisible(True)
        self._group, self._unit, self._act, self._refusal = group, unit, act, refusal
        self._add("isolate", translate("ThinPart", "&Isolate"), lambda: act("isolate"))
        self._add("show_all", translate("ThinPart", "Show &all"), lambda: act("show_all")).setEnabled(is_isolated)
        self.addSeparator()
        self._add_kept("exclude", translate("ThinPart", "&Exclude\u2026"), self._ask_reason)
        if group.excluded:
            self._add_kept("include", translate("ThinPart", "I&nclude again"), lambda: act("excluded", ""))
        self._add_kept("size", translate("ThinPart", "Set &mesh size\u2026"), self._ask_size)
        if group.mesh_size:
            self._add_kept("no_size", translate("ThinPart", "&Remove mesh size"), lambda: act("mesh_size_mm", 0.0))

    def _add(self, name, title, slot):
        action = self.addAction(title)
        action.setObjectName(f"ThinPart_Region_{name}")
        action.triggered.connect(lambda *_: slot())
        return action

    def _add_kept(self, name, title, slot):
        action = self._add(name, title, slot)
        action.setEnabled(not self._refusal)
        action.setToolTip(self._refusal or translate(
            "ThinPart", "Kept in the info file, also when the part is measured again; the verdict does not change"))

    def _ask_reason(self):
        reason, is_given = QtWidgets.QInputDialog.getText(
            self.parentWidget(), translate("ThinPart", "Exclude a wall"),
            translate("ThinPart", "Why it is left out, such as: a crush rib, thin on purpose"), text=self._group.excluded)
        if is_given and reason.strip():
            self._act("excluded", reason.strip())

    def _ask_size(self):
        unit = self._unit
        proposed = self._group.mesh_size or 0.5 * self._group.least  # two elements across the wall
        size, is_given = QtWidgets.QInputDialog.getDouble(
            self.parentWidget(), translate("ThinPart", "Mesh size of a wall"),
            translate("ThinPart", "Element size, {}").format(unit.symbol), unit.value(proposed),
            10.0 ** -unit.decimals, 1e6, unit.decimals)
        if is_given:
            self._act("mesh_size_mm", size * unit.millimetres)
