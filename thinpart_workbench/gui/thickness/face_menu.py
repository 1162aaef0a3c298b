# SPDX-License-Identifier: LGPL-2.1-or-later
"""The context menu of a face: limits of its own."""

from ..application.qt import QtWidgets, translate


class FaceMenu(QtWidgets.QMenu):
    """Sets and removes limits of the wall for one face.

    Parameters
    ----------
    row : FaceRow
    limit : dict
        The limits that it has: ``min_mm``, ``max_mm``, ``reason``; empty for none.
    unit : LengthUnit
    refusal : str
        Why nothing can be kept; empty if it can.
    act : callable
        Called with the new limits, with the same keys; empty to remove them.
    """

    def __init__(self, row, limit, unit, refusal, act, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_FaceMenu")
        self.setToolTipsVisible(True)
        self._row, self._limit, self._unit, self._act, self._refusal = row, limit, unit, act, refusal
        self._add("least", translate("ThinPart", "Set its &least wall\u2026"), lambda: self._ask("min_mm"))
        self._add("greatest", translate("ThinPart", "Set its &greatest wall\u2026"), lambda: self._ask("max_mm"))
        self._add("remove", translate("ThinPart", "&Remove its limits"), lambda: act({})).setEnabled(
            bool(limit) and not refusal)

    def _add(self, name, title, slot):
        action = self.addAction(title)
        action.setObjectName(f"ThinPart_Face_{name}")
        action.setEnabled(not self._refusal)
        action.setToolTip(self._refusal or translate(
            "ThinPart", "Kept in the info file with a reason; checks compare this face with it instead of the process"))
        action.triggered.connect(lambda *_: slot())
        return action

    def _ask(self, key):
        unit, title = self._unit, translate("ThinPart", "Limit for {}").format(self._row.name)
        proposed = self._limit.get(key) or self._row.summary.thinnest or 1.0
        words = (translate("ThinPart", "Least wall, {}") if key == "min_mm" else translate("ThinPart", "Greatest wall, {}"))
        wall, is_given = QtWidgets.QInputDialog.getDouble(
            self.parentWidget(), title, words.format(unit.symbol), unit.value(proposed), 10.0 ** -unit.decimals, 1e6,
            unit.decimals)
        if not is_given:
            return
        reason, is_given = QtWidgets.QInputDialog.getText(
            self.parentWidget(), title, translate("ThinPart", "Why, such as: a crush rib, thin on purpose"),
            text=self._limit.get("reason", ""))
        if is_given and reason.strip():
            self._act({**self._limit, key: wall * unit.millimetres, "reason": reason.strip()})
