# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of a measurement: a callback that takes the fraction done and may raise `Cancelled` to stop the work."""


def portion(report, start, end):
    """Make the callback for one part of the work, which itself reports from 0 to 1: callable or None.

    Parameters
    ----------
    report : callable or None
    start, end : float
        Fractions of all the work at which the part starts and ends.
    """
    return report and (lambda done: report(start + (end - start) * min(done, 1.0)))


def report_progress(report, done):
    """Report a fraction if there is a callback."""
    if report is not None:
        report(done)
