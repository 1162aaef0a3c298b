"""What `process_pool` and its workers tell each other: a kind, a length, and so many bytes."""

import struct

READY, TAKEN, DONE, FAILED = b"R", b"T", b"D", b"F"
"""A worker has started; it has taken a task; the task's result; what the task raised."""

GREETING = b"thinpart-pool-worker\n"
"""The first line of a worker: what comes before it was printed by the program that it runs in."""

_HEAD = struct.Struct("<cQ")


def write_message(pipe, kind, content=b""):
    """Write a message to a binary file and flush it.

    Raises
    ------
    OSError
        Where nobody reads any more.
    """
    pipe.write(_HEAD.pack(kind, len(content)))
    pipe.write(content)
    pipe.flush()


def read_message(pipe):
    """The next (kind, content) of a binary file.

    Raises
    ------
    EOFError
        Where the other process has ended.
    """
    kind, length = _HEAD.unpack(_read(pipe, _HEAD.size))
    return kind, _read(pipe, length)


def _read(pipe, length):
    content = pipe.read(length)
    if len(content) < length:
        raise EOFError
    return content
