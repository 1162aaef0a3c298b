# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window of the guide: the pages of docs as they lie on this computer, in the window's language where they are there in
it, with their links and pictures."""

import os

from ..application.language import language_of
from ..application.qt import QtCore, QtGui, QtWidgets, translate
from ..widgets.buttons import add_button
from .pages import CONTENTS, heading_anchor, languages, page_in

_WIDEST = 1400
"""Pixels of a picture: those of the guide are not sharp beyond."""


class GuideWindow(QtWidgets.QDialog):
    """Non-modal window with a page of the guide, and the way back."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_GuideWindow")
        self.setWindowTitle(translate("ThinPart", "ThinPart guide"))
        self.setWindowFlag(QtCore.Qt.WindowMaximizeButtonHint, True)
        column = QtWidgets.QVBoxLayout(self)
        row = QtWidgets.QHBoxLayout()
        column.addLayout(row)
        self._page = _GuidePage(self)
        self._page.setObjectName("ThinPart_GuidePage")
        for name, text, callback in (
                ("ThinPart_GuideContents", translate("ThinPart", "&Contents"), lambda: self.show_page(CONTENTS)),
                ("ThinPart_GuideBack", translate("ThinPart", "&Back"), self._page.backward),
                ("ThinPart_GuideForward", translate("ThinPart", "&Forward"), self._page.forward)):
            button = add_button(row, self, name, text, callback, is_for_enter=False)
            if name == "ThinPart_GuideBack":
                self._page.backwardAvailable.connect(button.setEnabled)
            elif name == "ThinPart_GuideForward":
                self._page.forwardAvailable.connect(button.setEnabled)
            button.setEnabled(name == "ThinPart_GuideContents")
        row.addStretch(1)
        add_button(row, self, "ThinPart_GuideClose", translate("ThinPart", "Close"), self.close,
                   is_for_enter=False)
        column.addWidget(self._page, 1)
        self.resize(840, 680)

    @property
    def page(self):
        """Path of the page that is shown."""
        return self._page.source().toLocalFile()

    def show_page(self, page):
        """Show a page in FreeCAD's language: its name, with ``#`` and an English heading if it is to begin there."""
        file, anchor = page_in(language_of(languages()), page)
        url = QtCore.QUrl.fromLocalFile(os.fspath(file))
        if anchor:
            url.setFragment(anchor)
        self._page.setSource(url)

    def end(self):
        """Delete the window."""
        self.hide()
        self.deleteLater()


class _GuidePage(QtWidgets.QTextBrowser):
    """A page of markdown. What is not one, such as an address in the internet, opens in the user's browser."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setOpenLinks(False)
        self.anchorClicked.connect(self._follow)
        self.sourceChanged.connect(self._on_shown)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOn)  # so that the width does not depend on the length
        self.document().setDocumentMargin(14)
        # Pictures fit the width: they are scaled again when it has changed.
        self._pictures, self._width_shown = [], 0
        self._resized = QtCore.QTimer(self, singleShot=True, interval=200)
        self._resized.timeout.connect(self._fit_pictures)

    def loadResource(self, kind, name):
        """A page as text, a picture no wider than the window."""
        if kind != QtGui.QTextDocument.ImageResource:
            return super().loadResource(kind, name)
        self._width_shown = self._text_width()
        if name not in self._pictures:
            self._pictures.append(name)
        return self._scaled(name)

    def _scaled(self, name):
        image = QtGui.QImage(name.toLocalFile())
        ratio = self.devicePixelRatioF()
        width = int(self._text_width() * ratio)
        if image.width() > width > 0:
            image = image.scaledToWidth(width, QtCore.Qt.SmoothTransformation)
        image.setDevicePixelRatio(ratio)
        return image

    def resizeEvent(self, event):
        """Scale the pictures once the new size stays."""
        super().resizeEvent(event)
        self._resized.start()

    def _text_width(self):
        return min(self.viewport().width() - 2 * int(self.document().documentMargin()) - 8, _WIDEST)

    def _fit_pictures(self):
        if self._width_shown == self._text_width():
            return
        self._width_shown = self._text_width()
        for name in self._pictures:
            self.document().addResource(QtGui.QTextDocument.ImageResource, name, self._scaled(name))
        self.document().markContentsDirty(0, self.document().characterCount())

    def _follow(self, link):
        url = self.source().resolved(link)
        if url.isLocalFile() and url.toLocalFile().endswith(".md") and os.path.isfile(url.toLocalFile()):
            self.setSource(url)
        else:
            QtGui.QDesktopServices.openUrl(url)

    def _on_shown(self, url):
        self._fit_pictures()
        self._format()
        self._scroll_to(url.fragment())

    def _format(self):
        """What markdown does not say: how tables and the code look."""
        line = self.palette().color(QtGui.QPalette.Disabled, QtGui.QPalette.Text)
        for frame in self.document().rootFrame().childFrames():
            if isinstance(frame, QtGui.QTextTable):
                style = frame.format()
                style.setCellPadding(4)
                style.setCellSpacing(0)
                style.setBorder(1)
                style.setBorderBrush(line)
                style.setBorderStyle(QtGui.QTextFrameFormat.BorderStyle_Solid)
                style.setBorderCollapse(True)
                style.setWidth(QtGui.QTextLength(QtGui.QTextLength.PercentageLength, 100))
                frame.setFormat(style)

    def _scroll_to(self, anchor):
        block = self.document().begin()
        while anchor and block.isValid():
            if block.blockFormat().headingLevel() and heading_anchor(block.text()) == anchor:
                top = self.document().documentLayout().blockBoundingRect(block).top()
                self.verticalScrollBar().setValue(int(top))
                return
            block = block.next()
        self.verticalScrollBar().setValue(0)
