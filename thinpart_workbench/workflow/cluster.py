"""Files analysed on a Dask cluster whose machines see the same share."""

import asyncio
import io
import json
import logging
import os
import queue
import time
import uuid
import warnings
import zipfile
from collections import deque
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from dataclasses import asdict
from pathlib import Path
from urllib.parse import urlsplit

from ..core.errors import ThinPartError
from .analysis_server import task_line
from .run_control import RunControl
from .worker_pool import failure

PATIENCE = 30.0
"""Seconds to wait for an answer, for a first worker, or for another when all have gone."""

_SECONDS_TO_CONNECT = 10.0
_SECONDS_TO_CLOSE = 5.0

_PER_THREAD = 3
"""Files handed out per thread of the workers: each has its next one at hand, the others stay here."""

_DASK_ERRORS = (OSError, RuntimeError, ValueError, CancelledError, asyncio.CancelledError,
                asyncio.TimeoutError)
"""What Dask's client raises, or lets through, where it does not reach its scheduler."""

_TICK = 0.2
"""Seconds after which the run looks what else there is to do."""

_ROOT = Path(__file__).resolve().parents[2]
_SENT = ("core", "storage", "freecad_adapter", "system", "workflow")


def cluster_address(text):
    """The address of a scheduler, complete, from what people write: ``HOST:PORT`` will do.

    Raises
    ------
    ThinPartError
        kind ``usage``.
    """
    address = text if "://" in text else f"tcp://{text}"
    try:
        parts = urlsplit(address)
        usable = parts.scheme in ("tcp", "tls") and parts.hostname and parts.port
    except ValueError:
        usable = False
    if not usable or parts.path or parts.query or parts.username:
        raise ThinPartError(
            f"'{text}' is no address of a Dask scheduler: write it as tcp://HOST:PORT.", "usage")
    return address


def analyse_files_on_cluster(address, tasks, limits, control=None, threads_seen=None,
                             patience=PATIENCE):
    """Analyse files on the workers of a Dask cluster, each in a process with time and memory limits.

    Parameters
    ----------
    address : str
        From `cluster_address`.
    tasks : list of FileTask
    limits : Limits
        `jobs` does not count: every thread of every worker takes one file at a time.
    control : RunControl, optional
        Pauses and stops the run. What the cluster has when it is paused it still does: a few files per
        thread.
    threads_seen : callable, optional
        ``threads_seen(number)`` is told how many files are analysed at once, whenever that changes.
    patience : float
        Seconds to wait for an answer of the scheduler, for a first worker, or for another one when all
        have gone.

    Yields
    ------
    dict
        As `worker_pool.analyse_files`.

    Raises
    ------
    KeyboardInterrupt
        When `control` was asked to stop.
    ThinPartError
        kind ``cluster``: the scheduler cannot be reached or was lost, there are no workers, or one
        cannot analyse files.

    Notes
    -----
    Dask does the files of a lost worker again elsewhere. A file whose worker was lost more often than
    the scheduler's ``distributed.scheduler.allowed-failures`` ends as one failure.
    """
    if not tasks:
        return
    control = control or RunControl()
    waiting = deque(tasks)
    with _connected(address, limits, patience, control, threads_seen) as cluster:
        while waiting or cluster.running:
            control.check()
            control.enter("paused" if control.paused else "running")
            while waiting and not control.paused and not cluster.is_full():
                cluster.submit(waiting.popleft())
            for outcome in cluster.outcomes():
                control.check()
                yield outcome


@contextmanager
def _connected(address, limits, patience, control, threads_seen):
    """A `_Cluster` for the time of a ``with`` block; its end cancels what still runs."""
    try:
        from distributed import Client
    except ImportError:
        raise ThinPartError("--dask needs Dask: install it with 'apt-get install "
                            "python3-distributed'.", "cluster") from None
    # What goes wrong is said in a sentence; Dask would add pages to it.
    for name in ("distributed", "distributed.client", "distributed.core", "distributed.utils",
                 "distributed.comm", "distributed.batched", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # versions that differ are told apart below
        try:
            client = Client(address, timeout=min(patience, _SECONDS_TO_CONNECT),
                            set_as_default=False, name="thinpart")
        except _DASK_ERRORS as error:
            raise ThinPartError(
                f"There is no Dask scheduler at {address} ({_first_line(error)}): start one there with "
                "'dask scheduler', or check the address.", "cluster") from None
    cluster = _Cluster(client, address, limits, patience, threads_seen)
    try:
        with _told_as_lost(address):
            cluster.start(control)
        yield cluster
    finally:
        cluster.close()


class _Cluster:
    """One run on a cluster: what was handed out, and what has come back."""

    def __init__(self, client, address, limits, patience, threads_seen):
        self.client, self.address, self.limits, self.patience = client, address, limits, patience
        self.threads_seen = threads_seen
        self.name = f"thinpart-{uuid.uuid4().hex}"
        self.running = {}
        self.versions = {}
        self._numbers = 0
        self._ended = queue.SimpleQueue()
        self._threads, self._looked, self._last_seen = 0, -1.0, time.monotonic()

    def start(self, control):
        """Wait for workers, send ThinPart to them, and ask all whether they can use it."""
        import cloudpickle

        from . import cluster_worker

        while not self._look():
            control.check()
            time.sleep(_TICK)
        self._refuse_other_python()
        # Workers cannot import the module, nor can the scheduler.
        cloudpickle.register_pickle_by_value(cluster_worker)
        self._analyse = _SentAsCode(cluster_worker.analyse)
        limits = {key: value for key, value in asdict(self.limits).items() if key != "jobs"}
        plugin = cluster_worker.AnalysisServers(self.name, _archive(), json.dumps(limits))
        register = getattr(self.client, "register_plugin", None) or self.client.register_worker_plugin
        self._within(lambda: register(plugin, name=self.name))
        answers = self._within(lambda: self.client.run(
            cluster_worker.software, self.name, on_error="return"))
        for answer in answers.values():
            # A worker that was lost meanwhile is none of ours any more.
            if isinstance(answer, dict):
                self._check_software(answer)

    def submit(self, task):
        """Hand a file to the cluster."""
        self._numbers += 1
        with _told_as_lost(self.address):
            future = self.client.submit(self._analyse, self.name, task_line(task), pure=False,
                                        key=f"{self.name}-{self._numbers}")
            self.running[future] = task
            future.add_done_callback(self._ended.put)

    def is_full(self):
        """Whether the workers have enough to do."""
        self._look()
        return len(self.running) >= max(2, _PER_THREAD * self._threads)

    def outcomes(self):
        """The outcomes of files that have ended meanwhile, if any."""
        self._look()
        ended = self._wait()
        if not ended:
            return
        with _told_as_lost(self.address):
            good = [future for future in ended if future.status == "finished"]
            # Where a worker is lost at this moment, Dask does its files again before it answers.
            values = self._within(lambda: self.client.gather(good, errors="skip"),
                                  self.limits.seconds + self.patience)
            answers = dict(zip(good, values))
            errors = {future: self._within(future.exception)
                      for future in ended if future.status == "error"}
        if len(values) + len(errors) < len(ended):
            raise ThinPartError(f"The Dask scheduler {self.address} was lost or gave the run up; what "
                                "was done is kept: start again.", "cluster")
        for future in ended:
            task = self.running.pop(future)
            future.release()
            if future in errors:
                yield _lost(task, errors[future])
                continue
            answer = answers[future]
            self._check_software(answer["software"])
            yield _outcome(task, answer["outcome"], answer["software"]["host"])

    def close(self):
        """Cancel what still runs, end the workers' processes, and leave the cluster as it was."""
        if self.client.status == "running":
            for farewell in (lambda: self.client.cancel(list(self.running)),
                             lambda: self.client.unregister_worker_plugin(self.name)):
                # A worker that is just lost or coming would be waited for; it does not need this.
                with suppress(*_DASK_ERRORS):
                    self._within(farewell, _SECONDS_TO_CLOSE)
        with suppress(*_DASK_ERRORS):
            self.client.close(timeout=2)

    def _wait(self):
        """Futures that have ended; none when none did for a moment."""
        ended = []
        with suppress(queue.Empty):
            ended.append(self._ended.get(timeout=_TICK))
            while True:
                ended.append(self._ended.get_nowait())
        return ended

    def _look(self):
        """How many threads the workers have; asked once a second."""
        if time.monotonic() < self._looked + 1:
            return self._threads
        with _told_as_lost(self.address):
            if self.client.status != "running":
                raise OSError("the connection was closed")
            threads = sum(self._within(self.client.nthreads).values())
        if threads != self._threads and self.threads_seen is not None:
            self.threads_seen(max(1, threads))
        self._threads = threads
        self._looked = time.monotonic()
        if self._threads:
            self._last_seen = self._looked
        elif self._looked > self._last_seen + self.patience:
            raise ThinPartError(
                f"The Dask scheduler {self.address} has no workers: start some with 'dask worker "
                f"{self.address} --nthreads 1'.", "cluster")
        return self._threads

    def _within(self, question, seconds=None):
        """Ask the cluster, but do not wait for ever for the answer."""
        async def ask():
            # Inside its event loop the client answers with something to wait for.
            return await question()

        return self.client.sync(ask, callback_timeout=seconds or self.patience)

    def _refuse_other_python(self):
        # Code travels between Pythons of one minor version only.
        versions = self._within(self.client.get_versions)
        ours = _minor(versions["client"])
        for where, entry in [(self.address, versions["scheduler"]), *versions["workers"].items()]:
            if _minor(entry) != ours:
                raise ThinPartError(
                    f"Python is {_minor(entry)} at {where} and {ours} here: scheduler, workers and this "
                    "machine need the same one, best the same Debian.", "cluster")

    def _check_software(self, software):
        """Refuse a worker that cannot analyse files, or would with another version of FreeCAD."""
        host = software["host"]
        if "lacks" in software:
            raise ThinPartError(f"The Dask worker on {host} cannot analyse files: {software['lacks']}. "
                                "Mend or stop it and start again; what was done is kept.", "cluster")
        self.versions.setdefault(software["freecad"], host)
        if len(self.versions) > 1:
            found = " and ".join(f"{version} on {host}" for version, host in self.versions.items())
            raise ThinPartError(f"The Dask workers have different versions of FreeCAD ({found}), whose "
                                "results differ: stop the workers with one of them.", "cluster")


class _SentAsCode:
    """A function that is unpickled without its module."""

    def __init__(self, function):
        import cloudpickle

        self._function, self._code = function, cloudpickle.dumps(function)

    def __reduce__(self):
        import cloudpickle

        return cloudpickle.loads, (self._code,)

    def __call__(self, *arguments):
        return self._function(*arguments)


def _archive():
    """ThinPart as a ZIP archive, without window and command line."""
    content = io.BytesIO()
    package = _ROOT / "thinpart_workbench"
    files = [*package.glob("*.py"), *(_ROOT / "resources" / "profiles").glob("*.json")]
    for layer in _SENT:
        files += (package / layer).rglob("*.py")
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            archive.writestr(os.fspath(file.relative_to(_ROOT)), file.read_bytes())
    return content.getvalue()


def _outcome(task, line, host):
    """What a worker answered, as for a file analysed here."""
    name = Path(task.file).name
    if line is None:
        return failure(task.file, "crash", f"{name} ended the process that read it on {host}: the file is "
                                           "likely damaged.")
    outcome = {**json.loads(line), "file": task.file}
    if outcome.get("error", {}).get("kind") == "missing" and os.path.exists(task.file):
        return failure(task.file, "missing",
                       f"The worker {host} does not see {os.path.abspath(task.file)}: mount the share "
                       "there under the same path.")
    return outcome


def _lost(task, error):
    """The outcome of a file that Dask gave up."""
    from distributed import KilledWorker

    name = Path(task.file).name
    if isinstance(error, KilledWorker):
        return failure(task.file, "crash",
                       f"{name} was given up by Dask: one worker after the other was lost with it.")
    return failure(task.file, "failed", f"{name} failed on the cluster ({_first_line(error)}).")


@contextmanager
def _told_as_lost(address):
    """Whatever Dask raises when it does not reach its scheduler, as one sentence."""
    try:
        yield
    except _DASK_ERRORS as error:
        raise ThinPartError(
            f"The Dask scheduler {address} does not answer any more ({_first_line(error)}); what was done "
            "is kept: start again.", "cluster") from None


def _minor(entry):
    return ".".join(entry["host"]["python"].split(".")[:2])


def _first_line(error):
    return (str(error).strip().splitlines() or [type(error).__name__])[0].rstrip(".")
