# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse the documents of a run and report on it."""

from contextlib import closing, contextmanager

from ..core.run_control import RunControl
from ..system.process_limits import MEMORY_CAN_BE_LIMITED
from .control_input import listen
from .run_report import new_report
from .stop_signals import stop_signals


@contextmanager
def controlled_run(options):
    """Context manager of a run that signals stop, and standard input with --control; see `add_control_options`.

    Yields `report` (RunReport), `control` (RunControl) and `undisturbed` (callable; see `stop_signals`).
    """
    report = new_report(options.json, options.control)
    control = RunControl(report.state)
    with stop_signals(control) as undisturbed, report:
        if options.control:
            listen(control)
        yield report, control, undisturbed


def analyse_and_report(run, report, add, *, checks=None, cluster=None, **how):
    """Analyse the documents of a run. Returns an int: number of files that failed completely or in part.

    Parameters
    ----------
    run : FileRun
    report : RunReport
    add : callable
        Called with each outcome, including those of folders that could not be searched.
    checks : PartChecks, optional
        Adds the results of checks to each outcome.
    cluster, how
        What to do with the documents: the arguments of `FileRun.outcomes`.
    """
    def started():
        report.started(run.progress)
        if cluster is None and not MEMORY_CAN_BE_LIMITED:
            report.note("On this system, --memory has no effect: the memory per file cannot be limited.")
        for outcome in run.failures:
            add(outcome)
            report.failures(outcome)

    with closing(run.outcomes(started=started, cluster=cluster, **how)) as outcomes:
        for outcome in outcomes:
            if checks is not None:
                outcome = checks.added_to(outcome)
            add(outcome)
            report.ended(outcome, run.progress)
    return run.progress.failed + len(run.failures)
