# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button with which the user says what a part is, where the verdict is not right."""

from ...core.categories import NORMAL
from ...freecad_adapter.preferences import preferred_person
from ..application.qt import QtCore, QtWidgets, Signal, translate
from .verdict_text import category_word


class LabelButton(QtWidgets.QToolButton):
    """A menu of the categories, each with one click; its text is the user's own label.

    Signals
    -------
    label_chosen(str, bool)
        The category, empty to remove the user's label, and whether the user is sure of it.
    """

    label_chosen = Signal(str, bool)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_Label")
        self.setPopupMode(QtWidgets.QToolButton.InstantPopup)
        self.setToolButtonStyle(QtCore.Qt.ToolButtonTextOnly)
        self.setFocusPolicy(QtCore.Qt.StrongFocus)
        self._menu = QtWidgets.QMenu(self)
        self._menu.setObjectName("ThinPart_LabelMenu")
        self.setMenu(self._menu)

    def sizeHint(self):
        """The size with room for the arrow, which some styles paint over the text."""
        size = super().sizeHint()
        return QtCore.QSize(size.width() + 4 * self.fontMetrics().averageCharWidth(), size.height())

    def minimumSizeHint(self):
        """As `sizeHint`."""
        return self.sizeHint()

    def show_labels(self, labels, profile, count=1):
        """Show the user's own label, if a part has it, and offer the categories of the profile that has judged it.

        Of several parts, `count`, how many they are is shown instead.
        """
        own = own_label(labels)
        if count > 1:
            self.setText(translate("ThinPart", "Label {} parts").format(count))
        else:
            self.setText(translate("ThinPart", "Not right?") if own is None else
                         translate("ThinPart", "My label: {}").format(_short_words(own, profile)))
        self.setToolTip(translate(
            "ThinPart", "Say what the part is in your eyes. The label is kept in the info file, as of {}; thresholds can be "
                        "learned from labels.").format(preferred_person()))
        self._fill_menu(own, profile)

    def _fill_menu(self, own, profile):
        menu = self._menu
        menu.clear()
        menu.addAction(translate("ThinPart", "I would say:")).setEnabled(False)
        for is_sure in (True, False):
            for category in [*(each.name for each in profile.categories), NORMAL]:
                action = menu.addAction(label_words({"category": category, "sure": is_sure}, profile))
                action.setObjectName(f"ThinPart_Label_{category}{'' if is_sure else '_unsure'}")
                action.setCheckable(True)
                action.setChecked(own is not None and (own["category"], own["sure"]) == (category, is_sure))
                action.triggered.connect(
                    lambda *_, category=category, is_sure=is_sure: self.label_chosen.emit(category, is_sure))
            menu.addSeparator()
        action = menu.addAction(translate("ThinPart", "Remove my label"))
        action.setObjectName("ThinPart_Label_remove")
        action.setEnabled(own is not None)
        action.triggered.connect(lambda *_: self.label_chosen.emit("", True))


def own_label(labels):
    """The user's label among those of a part, or None."""
    person = preferred_person()
    return next((label for label in labels if label["person"] == person), None)


def common_label(labels_of_parts):
    """The user's label that all of some parts have, as labels of one part: list of dict, empty where they differ."""
    own = [own_label(labels) for labels in labels_of_parts]
    return own[:1] if own and own[0] is not None and all(
        each and (each["category"], each["sure"]) == (own[0]["category"], own[0]["sure"]) for each in own) else []


def with_own_label(labels, category, is_sure):
    """The labels of a part as they are once the user's own is kept: list of dict."""
    own = own_label(labels)
    others = [label for label in labels if label != own]
    return others + ([{"person": preferred_person(), "category": category, "sure": is_sure}] if category else [])


def label_words(label, profile):
    """A label in words: its category, and whether its person is unsure of it."""
    word = category_word(label["category"], profile)
    return word if label["sure"] else translate("ThinPart", "{} (unsure)").format(word)


def _short_words(label, profile):
    # The button stands beside the verdict, in a panel that may be narrow.
    return category_word(label["category"], profile) + ("" if label["sure"] else "?")


def labels_sentence(labels, profile):
    """What people say of a part, in a line; empty where nobody says anything."""
    return ", ".join(translate("ThinPart", "{}: {}").format(label["person"], label_words(label, profile))
                     for label in labels)
