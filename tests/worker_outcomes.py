"""What becomes of tasks that are handed to workers."""

from thinpart_workbench.workflow.analyse_file import FileTask


def results(workers, tasks):
    """(task, result or name of the exception) in the order in which they end."""
    waiting, ended = [FileTask(task) for task in tasks], []
    while waiting or workers.busy:
        while waiting and workers.has_room:
            workers.begin(waiting.pop(0))
        one = workers.next_ended()
        if one is None:
            waiting[:0] = workers.lost_tasks()
            continue
        future, task, _ = one
        error = future.exception()
        ended.append((task.file, future.result() if error is None else type(error).__name__))
    return ended
