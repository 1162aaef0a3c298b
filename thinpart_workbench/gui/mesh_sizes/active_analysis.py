"""The analysis of FEM that the user is working on."""


def active_analysis(document):
    """The active analysis of a document; None without one, and without the FEM workbench."""
    try:
        import FemGui
    except ImportError:
        return None
    found = FemGui.getActiveAnalysis()
    return found if found is not None and found.Document == document else None
