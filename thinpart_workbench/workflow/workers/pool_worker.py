"""A worker of `process_pool`: ``python -m thinpart_workbench.workflow.workers.pool_worker``.

It receives its parent's process id and its confinement, then ``sys.path``, then its start function, and then tasks, one
after the other. It ends at the end of its input. It responds in JSON.
"""

import json
import os
import pickle
import sys

from ...system.confinement import BUBBLEWRAP, confine
from ...system.parent_death import end_with_parent
from .pool_messages import DONE, FAILED, GREETING, READY, TAKEN, encode_response, read_message, write_message


def main():
    """Process tasks until none are left."""
    requests, responses = _private_pipes()
    responses.write(GREETING)
    responses.flush()
    try:
        setup = json.loads(read_message(requests)[1])
        # Before importing anything else: an import may start threads.
        confinement = confine(setup["confinement"], setup["folder"])
        if setup["confinement"] != BUBBLEWRAP:  # bubblewrap is between the two processes, and ends this one itself
            end_with_parent(setup["parent"])
        sys.path[:] = pickle.loads(read_message(requests)[1])
        start, arguments = pickle.loads(read_message(requests)[1])
        start(*arguments)
        write_message(responses, READY, encode_response(confinement))
        while True:
            _, content = read_message(requests)
            write_message(responses, TAKEN)
            write_message(responses, *_outcome(content))
    except (EOFError, BrokenPipeError):
        return  # the pool is gone


def _outcome(content):
    try:
        work, arguments = pickle.loads(content)
        return DONE, encode_response(work(*arguments))
    except Exception as error:  # reported to the pool
        return FAILED, encode_response(f"{type(error).__name__}: {error}")


def _private_pipes():
    """The pipes from and to the pool; other code reads from the null device and prints to stderr."""
    requests, responses = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    return requests, responses


if __name__ == "__main__":
    main()
