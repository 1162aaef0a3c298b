# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do tasks, such as analysing files, on a Dask cluster whose machines have the same network share."""

import asyncio
import io
import json
import logging
import os
import platform
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

from ...core.errors import ThinPartError
from ...core.run_control import RunControl
from ..analysis.analysis_outcome import failure
from ..workers.task_run import Done
from .cluster_answer import THREADS, VERSIONS, checked, response_from, software_from
from .file_work import FILES
from .plain_pickles import PickleRefused, plain_pickles_only, texts_of_pickle

PATIENCE = 30.0
"""Seconds to wait for a response, for the first worker, or for another one when all have gone."""

_SECONDS_TO_CONNECT = 10.0
_SECONDS_TO_CLOSE = 5.0

_PER_THREAD = 3
"""Files submitted per thread of the workers: the running one and the next ones; the rest stays here."""

_DASK_ERRORS = (OSError, RuntimeError, ValueError, CancelledError, asyncio.CancelledError,
                asyncio.TimeoutError)
"""Exceptions that Dask's client raises, or passes on, if it cannot reach its scheduler."""

_TICK = 0.2
"""Seconds that the run waits for a finished file before it does other work."""

_ROOT = Path(__file__).resolve().parents[3]
_SENT_LAYERS = ("core", "storage", "freecad_adapter", "system", "workflow")


def analyse_files_on_cluster(address, tasks, limits, control=None, on_threads_changed=None,
                             patience=PATIENCE):
    """Analyse files on the workers of a Dask cluster, each in a process with time and memory limits.

    Yields a dict: see `worker_pool.analyse_files`. Raises Cancelled, ThinPartError: as `run_on_cluster`, which also has the
    parameters; the tasks are FileTask.
    """
    for done in run_on_cluster(address, tasks, FILES, limits, control, on_threads_changed, patience):
        yield done.failure or done.result


def run_on_cluster(address, tasks, work, limits, control=None, on_threads_changed=None, patience=PATIENCE):
    """Do tasks on the workers of a Dask cluster, each in a process with time and memory limits.

    Yields a Done: as they finish. Raises Cancelled when `control` was asked to stop. Raises ThinPartError,
    kind ``cluster``: the scheduler cannot be reached or was lost, there are no workers, or one cannot read files.

    Dask repeats the tasks of a lost worker on another one. A task whose workers were lost more often than
    the scheduler's ``distributed.scheduler.allowed-failures`` is reported as a failure.

    Parameters
    ----------
    address : str
        From `cluster_address`.
    tasks : list
        Each has the path of the document that it is about as ``file``.
    work : ClusterWork
        What is done with them.
    limits : Limits
        `jobs` is ignored: every thread of every worker does one task at a time.
    control : RunControl, optional
        Pauses and stops the run. A paused cluster still does the tasks that it has received: a few
        per thread.
    on_threads_changed : callable, optional
        ``on_threads_changed(number)`` is called when the number of tasks that are done at once changes.
    patience : float
        Seconds to wait for a response of the scheduler, for the first worker, or for another one when all
        have gone.
    """
    if not tasks:
        return
    control = control or RunControl()
    pending = deque(tasks)
    # Scheduler and workers are untrusted, and Dask unpickles whatever they send.
    with plain_pickles_only(), _connected(address, work, limits, patience, control, on_threads_changed) as cluster:
        while pending or cluster.running:
            control.check()
            control.set_state("paused" if control.paused else "running")
            while pending and not control.paused and not cluster.is_full():
                cluster.submit(pending.popleft())
            for done in cluster.finished():
                control.check()
                yield done


@contextmanager
def _connected(address, work, limits, patience, control, on_threads_changed):
    """A `_Cluster` for a ``with`` block; at its end, running files are cancelled."""
    try:
        from distributed import Client
    except ImportError:
        raise ThinPartError("--dask needs Dask: install it with 'apt-get install "
                            "python3-distributed'.", "cluster") from None
    # Errors are reported in one sentence; Dask would log pages in addition.
    for name in ("distributed", "distributed.client", "distributed.core", "distributed.utils",
                 "distributed.comm", "distributed.batched", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # `start` checks for different versions
        try:
            client = Client(address, timeout=min(patience, _SECONDS_TO_CONNECT),
                            set_as_default=False, name="thinpart")
        except _DASK_ERRORS as error:
            raise ThinPartError(
                f"There is no Dask scheduler at {address} ({_first_line(error)}): start one there with "
                "'dask scheduler', or check the address.", "cluster") from None
    cluster = _Cluster(client, address, work, limits, patience, on_threads_changed)
    try:
        cluster.start(control)
        yield cluster
    finally:
        cluster.close()


class _Cluster:
    """One run on a cluster: the submitted and the finished tasks."""

    def __init__(self, client, address, work, limits, patience, on_threads_changed):
        self.client, self.address, self.work, self.limits, self.patience = client, address, work, limits, patience
        self.on_threads_changed = on_threads_changed
        self.name = f"thinpart-{uuid.uuid4().hex}"
        self.running = {}
        self.versions = {}
        self._count = 0
        self._finished: queue.SimpleQueue = queue.SimpleQueue()
        self._threads, self._updated_at, self._workers_seen_at = 0, -1.0, time.monotonic()

    def start(self, control):
        """Wait for workers, send ThinPart to them, and check that all can run it."""
        import cloudpickle

        from . import cluster_worker

        while not self._update_threads():
            control.check()
            time.sleep(_TICK)
        self._refuse_other_python()
        # Neither the workers nor the scheduler can import the module.
        cloudpickle.register_pickle_by_value(cluster_worker)
        self._analyse = _FunctionByValue(cluster_worker.analyse)
        limits = {key: value for key, value in asdict(self.limits).items() if key != "jobs"}
        plugin = cluster_worker.AnalysisServers(self.name, _archive(), self.work.name, json.dumps(limits))
        register = getattr(self.client, "register_plugin", None) or self.client.register_worker_plugin
        self._ask(lambda: register(plugin, name=self.name))
        responses = self._ask(lambda: self.client.run(
            cluster_worker.software, self.name, on_error="return"))
        for address, response in responses.items():
            # Ignore a worker that was lost meanwhile.
            if not isinstance(response, BaseException):
                try:
                    self._check_software(software_from(response))
                except ValueError as error:
                    raise ThinPartError(
                        f"The Dask worker {address} gave an answer that is not ThinPart's ({error}): stop it and start "
                        "again; finished results are saved.", "cluster") from None

    def submit(self, task):
        """Submit a task to the cluster."""
        self._count += 1
        with _scheduler_lost_errors(self.address):
            future = self.client.submit(self._analyse, self.name, json.dumps(self.work.content(task)), pure=False,
                                        key=f"{self.name}-{self._count}")
            self.running[future] = task
            future.add_done_callback(self._finished.put)

    def is_full(self):
        """Whether the workers have enough tasks."""
        self._update_threads()
        return len(self.running) >= max(2, _PER_THREAD * self._threads)

    def finished(self):
        """Yield the Done of the tasks that have finished meanwhile."""
        self._update_threads()
        finished = self._finished_futures()
        if not finished:
            return
        succeeded = [future for future in finished if future.status == "finished"]
        # If a worker is lost now, Dask repeats its files before it responds.
        values = self._ask(lambda: self.client.gather(succeeded, errors="skip"), self.limits.seconds + self.patience)
        responses = dict(zip(succeeded, values))
        errors = {future: self._ask(future.exception) for future in finished if future.status == "error"}
        if len(values) + len(errors) < len(finished):
            raise ThinPartError(f"The Dask scheduler {self.address} was lost or gave the run up; "
                                "finished results are saved: start again.", "cluster")
        for future in finished:
            task = self.running.pop(future)
            future.release()
            if future in errors:
                yield Done(task, failure=_given_up(task, errors[future]))
                continue
            try:
                software, done = response_from(responses[future], task, self.work.done)
            except ValueError:
                yield Done(task, failure=failure(
                    task.file, "failed", f"{Path(task.file).name} failed on the cluster (a worker answered with something "
                                         "else than a result)."))
                continue
            self._check_software(software)
            yield self._told(task, done, software["host"])

    def _told(self, task, done, host):
        """The Done of a task that a worker returned, with the errors of this machine; it returned None where it died."""
        if done is None:
            return Done(task, failure=failure(
                task.file, "crash", f"{Path(task.file).name} ended the process that read it on {host}: the file is likely "
                                    "damaged."))
        files = self.work.files(task)
        if done.failure is not None and done.failure["error"]["kind"] == "missing" and all(map(os.path.exists, files)):
            places = " or ".join(map(os.path.abspath, files))
            return Done(task, failure=failure(
                task.file, "missing",
                f"The worker {host} does not see {places}: mount the share there under the same path."))
        return done

    def close(self):
        """Cancel running tasks, end the processes of the workers, and restore the state of the cluster."""
        if self.client.status == "running":
            for cleanup in (lambda: self.client.cancel(list(self.running)),
                             lambda: self.client.unregister_worker_plugin(self.name)):
                # Dask would wait for workers that are being lost or added, which need no cleanup.
                with suppress(ThinPartError):
                    self._ask(cleanup, _SECONDS_TO_CLOSE)
        with suppress(*_DASK_ERRORS):
            self.client.close(timeout=2)

    def _finished_futures(self):
        """Futures that have finished; empty if none finishes within `_TICK`."""
        finished = []
        with suppress(queue.Empty):
            finished.append(self._finished.get(timeout=_TICK))
            while True:
                finished.append(self._finished.get_nowait())
        return finished

    def _update_threads(self):
        """Number of threads of the workers; updated at most once a second."""
        if time.monotonic() < self._updated_at + 1:
            return self._threads
        with _scheduler_lost_errors(self.address):
            if self.client.status != "running":
                raise OSError("the connection was closed")
        threads = sum(self._valid(THREADS, self._ask(self.client.nthreads)).values())
        if threads != self._threads and self.on_threads_changed is not None:
            self.on_threads_changed(max(1, threads))
        self._threads = threads
        self._updated_at = time.monotonic()
        if self._threads:
            self._workers_seen_at = self._updated_at
        elif self._updated_at > self._workers_seen_at + self.patience:
            raise ThinPartError(
                f"The Dask scheduler {self.address} has no workers: start some with 'dask worker "
                f"{self.address} --nthreads 1'.", "cluster")
        return self._threads

    def _ask(self, request, seconds=None):
        """Run a request of the client with a time limit; ThinPartError if the scheduler does not answer."""
        async def send():
            # In its event loop the client returns awaitables.
            try:
                return await request()
            except PickleRefused as error:
                raise ThinPartError(
                    f"Dask at {self.address} sent a program where data was expected ({error}), which was not run: do "
                    "not use that cluster.", "cluster") from None
            except Exception as error:
                if type(error) is not Exception:
                    raise
                raise RuntimeError(_first_line(error)) from None  # an exception of Dask, which contains a pickle

        with _scheduler_lost_errors(self.address):
            return self.client.sync(send, callback_timeout=seconds or self.patience)

    def _refuse_other_python(self):
        # Pickled code only works with the same minor version of Python.
        ours = _minor(platform.python_version())
        versions = self._valid(VERSIONS, self._ask(self.client.get_versions))
        for address, entry in [(self.address, versions["scheduler"]), *versions["workers"].items()]:
            version = entry["host"]["python"]
            if _minor(version) != ours:
                raise ThinPartError(
                    f"Python is {_minor(version)} at {address} and {ours} here: scheduler, workers and this "
                    "machine need the same one, best the same Debian.", "cluster")

    def _valid(self, kind, answer):
        """An answer of the scheduler; ThinPartError if it is none."""
        try:
            return checked(kind, answer)
        except ValueError as error:
            raise ThinPartError(
                f"The Dask scheduler {self.address} gave an answer that is not Dask's ({error}): restart it.",
                "cluster") from None

    def _check_software(self, software):
        """Refuse a worker that cannot analyse files, or that has another version of FreeCAD."""
        host = software["host"]
        if "lacks" in software:
            raise ThinPartError(f"The Dask worker on {host} cannot analyse files: {software['lacks']}. "
                                "Repair or stop it and start again; finished results are saved.", "cluster")
        self.versions.setdefault(software["freecad"], host)
        if len(self.versions) > 1:
            found = " and ".join(f"{version} on {host}" for version, host in self.versions.items())
            raise ThinPartError(f"The Dask workers have different versions of FreeCAD ({found}), whose "
                                "results differ: stop the workers with one of them.", "cluster")


class _FunctionByValue:
    """A function that is pickled by value: unpickling needs no module."""

    def __init__(self, function):
        import cloudpickle

        self._function, self._code = function, cloudpickle.dumps(function)

    def __reduce__(self):
        import cloudpickle

        return cloudpickle.loads, (self._code,)

    def __call__(self, *arguments):
        return self._function(*arguments)


def _archive():
    """ThinPart as a ZIP archive, without GUI and command line."""
    content = io.BytesIO()
    package = _ROOT / "thinpart_workbench"
    files = [*package.glob("*.py"), *(_ROOT / "resources" / "profiles").glob("*.json"),
             *(_ROOT / "resources" / name for name in ("colour_maps.json", "mesh_risk.json"))]
    for layer in _SENT_LAYERS:
        files += (package / layer).rglob("*.py")
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            archive.writestr(os.fspath(file.relative_to(_ROOT)), file.read_bytes())
    return content.getvalue()


def _given_up(task, error):
    """The failure of a task that Dask has given up."""
    name = Path(task.file).name
    if "KilledWorker" in (type(error).__name__, *_pickled_texts(error)):
        return failure(task.file, "crash",
                       f"{name} was given up by Dask: one worker after the other was lost with it.")
    return failure(task.file, "failed", f"{name} failed on the cluster ({_first_line(error)}).")


@contextmanager
def _scheduler_lost_errors(address):
    """Convert the exceptions of Dask for an unreachable scheduler to a ThinPartError."""
    try:
        yield
    except _DASK_ERRORS as error:
        raise ThinPartError(
            f"The Dask scheduler {address} does not answer any more ({_first_line(error)}); finished "
            "results are saved: start again.", "cluster") from None


def _minor(version):
    return ".".join(version.split(".")[:2])


def _first_line(error):
    text, pickled = str(error), _pickled_texts(error)
    if pickled:
        text = next((text for text in pickled if " " in text), "")  # the others are the names of modules and classes
    return (text.strip().splitlines() or [type(error).__name__])[0].rstrip(".")


def _pickled_texts(error):
    """Texts in an exception that contains a pickle, without unpickling it; empty for other exceptions."""
    content = error.args[0] if error.args else None
    return texts_of_pickle(content) if isinstance(content, (bytes, bytearray)) else []
