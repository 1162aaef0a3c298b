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
        warning = loose_faces_warning(shape, "The file")
        return shape.Solids, (warning,) if warning else ()
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


def loose_faces_warning(shape, whose):
    """A sentence about faces that lie beside the solids of a shape; None where there are none.

    Parameters
    ----------
    shape : Part.Shape
        With solids.
    whose : str
        What the shape belongs to, as the start of the sentence.
    """
    import Part

    # Neighbouring solids may share a face, so that it does not do to add up their numbers.
    loose = len(shape.Faces) - len(Part.Compound(shape.Solids).Faces)
    if loose <= 0:
        return None
    if loose == 1:
        return (f"{whose} holds 1 face beside its solids, which was left out: close or thicken it if it "
                "is a part.")
    return (f"{whose} holds {loose} faces beside its solids, which were left out: close or thicken them "
            "if they are a part.")
