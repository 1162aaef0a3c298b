# SPDX-License-Identifier: LGPL-2.1-or-later
"""How tables look and behave that show one record per row."""

from ..application.qt import QtWidgets


def show_whole_rows(view):
    """Set up a QTableView for records: one row is selected at a time, and Tab leaves the table."""
    view.setSelectionBehavior(QtWidgets.QAbstractItemView.SelectRows)
    view.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
    view.setHorizontalScrollMode(QtWidgets.QAbstractItemView.ScrollPerPixel)
    view.setTabKeyNavigation(False)
    view.setAlternatingRowColors(True)
    view.setShowGrid(False)
    view.setWordWrap(False)
    view.verticalHeader().hide()
    view.horizontalHeader().setHighlightSections(False)
