"""What becomes of tasks that are handed to workers."""

from thinpart_workbench.workflow.analysis.analyse_file import FileTask


def results(workers, tasks):
    """(task, result, or what was raised there, or the name of what became of it) in the order in which they end."""
    waiting, ended = [FileTask(task) for task in tasks], []
    while waiting or workers.busy:
        while waiting and workers.has_room:
            workers.submit(waiting.pop(0))
        one = workers.next_finished()
        if one is None:
            waiting[:0] = workers.lost_tasks()
            continue
        future, task = one
        error = future.exception()
        ended.append((task.file, future.result() if error is None else str(error) or type(error).__name__))
    return ended
