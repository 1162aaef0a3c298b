# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the answers of Dask's scheduler and workers, which are untrusted."""

from ...core.kinds.compound_kinds import MapOf, Record
from ...core.kinds.json_file import UnreadableJson, parsed_json
from ...core.kinds.value_kinds import Text, Whole

_SOFTWARE = Record({"host": Text()}, {name: Text() for name in ("lacks", "thinpart", "freecad", "python")})

_RUNS_ON = Record({"host": Record({"python": Text()})})

VERSIONS = Record({"scheduler": _RUNS_ON, "workers": MapOf(_RUNS_ON)})
"""Kind of the software of a cluster, of which only Python matters; workers by their addresses."""

THREADS = MapOf(Whole(0, 1_000_000))
"""Kind of the number of threads of each worker."""


def checked(kind, content):
    """Content of a kind. Raises ValueError if it is of none; the text says why."""
    fault = kind.fault(content, "")
    if fault is not None:
        raise ValueError(fault)
    return content


def software_from(text):
    """The software of a worker: texts ``host`` and either ``lacks`` or ``freecad``; ValueError if it is invalid."""
    return _software(_parsed(text))


def response_from(text, task, done):
    """The two parts of a response. Raises ValueError if it is invalid; the text says why.

    Parameters
    ----------
    text : object
        The received result of `cluster_worker.analyse`.
    task : object
    done : callable
        That of the `ClusterWork`.

    Returns
    -------
    software : dict
        See `software_from`.
    done : Done or None
        None if the process died.
    """
    response = _parsed(text)
    if not isinstance(response, dict) or set(response) != {"software", "outcome"}:
        raise ValueError("no software or no outcome")
    outcome = response["outcome"]
    return _software(response["software"]), None if outcome is None else done(task, _parsed(outcome))


def _software(content):
    checked(_SOFTWARE, content)
    if "lacks" not in content and "freecad" not in content:
        raise ValueError("no software")
    return content


def _parsed(text):
    if not isinstance(text, str):
        raise ValueError(f"a {type(text).__name__} instead of a text")
    try:
        return parsed_json(text.encode())
    except UnreadableJson as problem:
        raise ValueError(str(problem)) from None
