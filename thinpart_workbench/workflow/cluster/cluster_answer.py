"""Parse and check the responses of Dask workers, which are untrusted."""

import json

from ...core.kinds.compound_kinds import MapOf, Record
from ...core.kinds.value_kinds import Text, Whole
from ..analysis.analysis_outcome import checked_outcome

_SOFTWARE = Record({"host": Text()}, {name: Text() for name in ("lacks", "thinpart", "freecad", "python")})

_RUNS_ON = Record({"host": Record({"python": Text()})})

_VERSIONS = Record({"scheduler": _RUNS_ON, "workers": MapOf(_RUNS_ON)})

_THREADS = MapOf(Whole(0, 1_000_000))


def pythons_from(versions):
    """Versions of Python by address, as Dask's scheduler tells them; that of the scheduler itself is under the empty text.

    Raises
    ------
    ValueError
        If they are invalid.
    """
    _raise_fault(_VERSIONS.fault(versions, "versions"))
    return {address: entry["host"]["python"]
            for address, entry in [("", versions["scheduler"]), *versions["workers"].items()]}


def threads_from(threads):
    """Number of threads of all workers, from those of each, as Dask's scheduler tells them.

    Raises
    ------
    ValueError
        If they are invalid.
    """
    _raise_fault(_THREADS.fault(threads, "threads"))
    return sum(threads.values())


def response_from(text, task):
    """The two parts of a response.

    Parameters
    ----------
    text : object
        The received result of `cluster_worker.analyse`.
    task : FileTask

    Returns
    -------
    software : dict
        See `software_from`.
    outcome : dict or None
        The outcome of `analyse_file`, or ``error``; None if the process died.

    Raises
    ------
    ValueError
        If it is invalid; the text says why.
    """
    response = _json(text)
    _raise_fault(None if set(response) == {"software", "outcome"} else "no software or no outcome")
    _check_software(response["software"])
    if response["outcome"] is None:
        return response["software"], None
    return response["software"], checked_outcome(task, _json(response["outcome"]))


def software_from(text):
    """The software of a worker: texts ``host`` and either ``lacks`` or ``freecad``.

    Raises
    ------
    ValueError
        If it is invalid.
    """
    software = _json(text)
    _check_software(software)
    return software


def _json(text):
    _raise_fault(None if isinstance(text, str) else f"a {type(text).__name__} instead of a text")
    try:
        content = json.loads(text)
    except RecursionError:
        raise ValueError("it is nested too deep") from None
    _raise_fault(None if isinstance(content, dict) else "no object of JSON")
    return content


def _check_software(content):
    _raise_fault(_SOFTWARE.fault(content, "software"))
    _raise_fault(None if "lacks" in content or "freecad" in content else "no software")


def _raise_fault(fault):
    if fault is not None:
        raise ValueError(fault)
