"""Planned files analysed one after the other, with what is said meanwhile."""

from contextlib import closing

from ..system.process_limits import MEMORY_CAN_BE_LIMITED
from ..workflow.cluster import analyse_files_on_cluster
from ..workflow.run_progress import RunProgress
from ..workflow.worker_pool import analyse_files


def analyse_planned(planned, failures, limits, control, report, add, cluster=None):
    """Analyse files.

    Parameters
    ----------
    planned : list of PlannedFile
    failures : list of dict
        Outcomes of what could not be searched.
    limits : Limits
    control : RunControl
    report : Report
    add : callable
        Takes each outcome, those failures among them.
    cluster : str, optional
        Address of a Dask scheduler whose workers do it, in place of processes of this machine.

    Returns
    -------
    int
        Number of files that failed, as a whole or in part.
    """
    progress = RunProgress({each.task.file: (each.bytes, each.unchanged) for each in planned}, limits.jobs)
    unkept = {each.task.file: each.problem for each in planned if each.problem is not None}
    control.enter("paused" if control.paused else "running")
    report.started(progress)
    if cluster is None and not MEMORY_CAN_BE_LIMITED:
        report.note("The memory that a file may take cannot be limited on this system.")
    for outcome in failures:
        add(outcome)
        report.failures(outcome)
    with closing(_outcomes([each.task for each in planned], limits, control, progress, cluster)) as outcomes:
        for outcome in outcomes:
            if outcome["file"] in unkept and "error" not in outcome:
                error = unkept[outcome["file"]]
                outcome["failures"] = [*outcome["failures"], {
                    "part": None, "label": None, "kind": error.kind, "message": str(error)}]
            add(outcome)
            progress.add(outcome)
            report.ended(outcome, progress)
    return progress.failed + len(failures)


def _outcomes(tasks, limits, control, progress, cluster):
    """What analyses the files: worker processes of this machine, or a cluster."""
    if cluster is None:
        return analyse_files(tasks, limits, control)

    def threads_seen(threads):
        progress.jobs = threads

    return analyse_files_on_cluster(cluster, tasks, limits, control, threads_seen)
