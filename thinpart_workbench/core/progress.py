"""Progress of a measurement: a callable that is given the fraction done and may raise to stop."""


def portion(report, start, end):
    """The report of a part of the work, which runs from 0 to 1 itself.

    Parameters
    ----------
    report : callable or None
    start, end : float
        Fractions of the whole at which the part starts and ends.

    Returns
    -------
    callable or None
    """
    return report and (lambda done: report(start + (end - start) * min(done, 1.0)))


def tell(report, done):
    """Report a fraction, if anyone wants to know."""
    if report is not None:
        report(done)
