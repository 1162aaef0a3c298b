# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis of FEM that a mesh joins."""

from ...freecad_adapter.objects.fem_analysis import analysis_for, new_analysis
from ..application.qt import translate


def active_analysis(document):
    """The active analysis of a document; None without one, and without the FEM workbench."""
    try:
        import FemGui
    except ImportError:
        return None
    found = FemGui.getActiveAnalysis()
    return found if found is not None and found.Document == document else None


def analysis_to_join(document, owner, is_made):
    """The analysis that a mesh of an object joins: the active one, or else, if that is wanted, one that may have it or a new
    one; or None."""
    found = active_analysis(document)
    if found is not None or not is_made:
        return found
    found = analysis_for(document, owner) or new_analysis(document, translate("ThinPart", "Analysis"),
                                                        translate("ThinPart", "Steel (replace it)"))
    try:
        import FemGui

        FemGui.setActiveAnalysis(found)
    except ImportError:
        pass
    return found
