# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signals about the documents that panels measure, so that no other component measures them too."""

from ..application.qt import QtCore, Signal


class MeasurementSignals(QtCore.QObject):
    """Emitted by every `DocumentMeasurement`. The first argument is the document's name, None where there is none.

    Signals
    -------
    begun(object)
        A panel has started measuring the whole document.
    info_file_abandoned(object)
        The panel was closed or cancelled: it will write no info file.
    written(object, object, object)
        The panel has written the info file. Arguments two and three: the verdicts in it before and now.
    not_written(object, object)
        The panel could not write the info file, and has reported that. Argument two: the sentence.
    """

    begun = Signal(object)
    info_file_abandoned = Signal(object)
    written = Signal(object, object, object)
    not_written = Signal(object, object)
