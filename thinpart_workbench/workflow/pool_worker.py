"""A worker of `process_pool`: ``python -m thinpart_workbench.workflow.pool_worker``.

It is told where modules lie and how to start, and then tasks, one after the other. It ends with its input.
"""

import os
import pickle
import sys

from .pool_messages import DONE, FAILED, GREETING, READY, TAKEN, read_message, write_message


def main():
    """Do tasks until there are no more."""
    requests, answers = _private_pipes()
    answers.write(GREETING)
    answers.flush()
    try:
        sys.path[:] = pickle.loads(read_message(requests)[1])
        start, arguments = pickle.loads(read_message(requests)[1])
        start(*arguments)
        write_message(answers, READY)
        while True:
            _, content = read_message(requests)
            write_message(answers, TAKEN)
            write_message(answers, *_outcome(content))
    except (EOFError, BrokenPipeError):
        return  # the pool is gone


def _outcome(content):
    try:
        work, arguments = pickle.loads(content)
        return DONE, pickle.dumps(work(*arguments))
    except Exception as error:  # whoever has asked is told, whatever it is
        try:
            content = pickle.dumps(error)
            pickle.loads(content)  # some exceptions are written and cannot be read again
        except Exception:  # __reduce__ and constructors of foreign classes raise what they like
            content = pickle.dumps(RuntimeError(f"{type(error).__name__}: {error}"))
        return FAILED, content


def _private_pipes():
    """The pipes to the pool. What others print, or read, is not theirs."""
    requests, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    return requests, answers


if __name__ == "__main__":
    main()
