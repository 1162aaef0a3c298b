"""Closed solids out of whatever shape an exchange file holds."""

SEWING_TOLERANCES = (1e-6, 1e-5, 1e-4)
"""Shares of the diagonal that loose faces may lie apart; tried from tight to loose."""


def solids_of(shape):
    """Solids of a shape, sewn together where it came as loose faces.

    Parameters
    ----------
    shape : Part.Shape

    Returns
    -------
    solids : list of Part.Shape
        Empty where the surfaces do not close.
    warnings : tuple of str

    Notes
    -----
    IGES brings faces without solids; they are sewn first.
    """
    if shape.Solids:
        return shape.Solids, ()
    if not shape.Faces:
        return [], ()
    diagonal = shape.BoundBox.DiagonalLength
    for tolerance in SEWING_TOLERANCES:
        sewn = shape.copy()
        sewn.sewShape(tolerance * diagonal)
        solids = _closed_solids(sewn)
        if solids:
            return solids, (
                f"It came as {len(shape.Faces)} loose faces, which were sewn together.",
            )
    return [], ()


def _closed_solids(shape):
    import Part

    return [Part.Solid(shell) for shell in shape.Shells if shell.isClosed()]
