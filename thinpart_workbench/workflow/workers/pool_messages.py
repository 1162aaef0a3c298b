# SPDX-License-Identifier: LGPL-2.1-or-later
"""The messages between `process_pool` and its workers: a kind, a length and the content."""

import json
import struct

from ...core.message import restored, with_messages

READY, TAKEN, CONFINED, DONE, FAILED = b"R", b"T", b"C", b"D", b"F"
"""Kinds of messages: worker started; task received; confinement during the task; its result; its exception."""

PART, ENDED = b"P", b"E"
"""Kinds of messages of a worker that forks: bytes of the messages of the process of a task; its exit code."""

GREETING = b"thinpart-pool-worker\n"
"""The first line of a worker: anything before it was printed by the program that it runs in."""

LARGEST = 1 << 30
"""Maximum bytes of a message, and of all parts of one; a faulty worker may announce any length."""

_HEAD = struct.Struct("<cQ")


class InvalidMessage(Exception):
    """The received data is not a message, or not JSON."""


def write_message(pipe, kind, content=b""):
    """Write a message to a binary file and flush it. Raises OSError if the reader has closed the pipe."""
    pipe.write(_HEAD.pack(kind, len(content)))
    pipe.write(content)
    pipe.flush()


def read_message(pipe):
    """Read the next message from a binary file: (kind, content).

    Raises EOFError if the other process has ended; InvalidMessage if the message is longer than `LARGEST`.
    """
    kind, length = _HEAD.unpack(_read(pipe, _HEAD.size))
    if length > LARGEST:
        raise InvalidMessage(f"a message of {length} bytes")
    return kind, _read(pipe, length)


def encode_response(value):
    """Encode the response of a worker; `Message` texts keep their templates and fields.

    Raises TypeError, ValueError for values that JSON cannot represent, such as numbers that are not finite.
    """
    return json.dumps(with_messages({"value": value}), allow_nan=False).encode()


def decode_response(content):
    """Decode the response of a worker. Raises InvalidMessage."""
    try:
        return restored(json.loads(content))["value"]
    except (ValueError, RecursionError, TypeError, KeyError) as error:
        raise InvalidMessage(str(error)) from None


def _read(pipe, length):
    content = pipe.read(length)
    if len(content) < length:
        raise EOFError
    return content
