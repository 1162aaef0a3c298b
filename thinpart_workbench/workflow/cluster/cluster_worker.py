# SPDX-License-Identifier: LGPL-2.1-or-later
"""The code that runs in a Dask worker. It is pickled by value, so it imports nothing of ThinPart.

The package itself is sent as an archive that every worker unpacks: the machines need Debian's packages, but not
ThinPart, and all use the version of the machine that started the run. Workers return JSON, since that machine does
not trust them.
"""

import asyncio
import io
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
import zipfile

from distributed import Reschedule, WorkerPlugin, get_worker

_SERVER = "thinpart_workbench.workflow.cluster.analysis_server"
_SECONDS_TO_END = 10


class AnalysisServers(WorkerPlugin):
    """The processes of one Dask worker that do the tasks: one per thread that requests one.

    Parameters
    ----------
    name : str
        Name of this plugin, unique for every run.
    archive : bytes
        A ZIP archive of ThinPart.
    work : str
        Name of the `ClusterWork`.
    limits : str
        JSON of the `Limits` for one task.
    """

    def __init__(self, name, archive, work, limits):
        self.name, self.archive, self.work, self.limits = name, archive, work, limits

    def setup(self, worker):
        """Unpack ThinPart; called by Dask, also on workers that join later."""
        self.lock = threading.Lock()
        self.servers, self.idle, self.closed, self.versions = [], [], False, None
        self.folder = tempfile.mkdtemp(prefix="thinpart-", dir=worker.local_directory)
        with zipfile.ZipFile(io.BytesIO(self.archive)) as archive:
            archive.extractall(self.folder)

    def teardown(self, worker):
        """End the processes, even during a task; called by Dask."""
        with self.lock:
            self.closed = True
            servers = list(self.servers)
        for server in servers:
            server.stdin.close()
        # In a thread, since Dask calls this in its event loop.
        threading.Thread(target=self._clear, args=(servers,)).start()

    def _clear(self, servers):
        for server in servers:
            try:
                server.wait(_SECONDS_TO_END)
            except subprocess.TimeoutExpired:
                server.kill()
        shutil.rmtree(self.folder, ignore_errors=True)

    def software(self):
        """Software versions or what is missing, and the host name; determined once."""
        with self.lock:
            if self.versions is None:
                run = subprocess.run(
                    [sys.executable, "-m", _SERVER, "--check"], capture_output=True,
                    stdin=subprocess.DEVNULL, **self._popen_options())
                try:
                    self.versions = json.loads(run.stdout)
                except ValueError:
                    last = run.stderr.decode(errors="replace").strip().splitlines()[-1:]
                    self.versions = {"lacks": f"ThinPart does not start there ({' '.join(last)})"}
                self.versions["host"] = socket.gethostname()
            return self.versions

    def analyse(self, task):
        """Do one task by a line of JSON: JSON of ``software``, and ``outcome``, JSON or None if the process died."""
        versions = self.software()
        if "lacks" in versions:
            return json.dumps({"software": versions, "outcome": None})
        line = b""
        for _ in range(2):
            server = self._acquire_server()
            try:
                server.stdin.write(task.encode() + b"\n")
                server.stdin.flush()
                line = server.stdout.readline()
            except (OSError, ValueError):
                line = b""  # ended or closed meanwhile
            if line:
                with self.lock:
                    self.idle.append(server)
                break
            if self.closed:
                # This worker is shutting down: another one processes the file.
                raise Reschedule()
            if server.wait():
                break
            # The process had ended by itself after being idle: try another one.
        return json.dumps({"software": versions, "outcome": line.decode() or None})

    def _acquire_server(self):
        with self.lock:
            while self.idle:
                server = self.idle.pop()
                if server.poll() is None:
                    return server
            if self.closed:
                raise Reschedule()
            self.servers = [server for server in self.servers if server.poll() is None]
            server = subprocess.Popen(
                [sys.executable, "-m", _SERVER, self.work, self.limits], stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, **self._popen_options())
            self.servers.append(server)
            return server

    def _popen_options(self):
        path = os.pathsep.join(filter(None, (self.folder, os.environ.get("PYTHONPATH"))))
        # In a session of its own: Ctrl-C in the terminal of the Dask worker is handled by that worker.
        return {"cwd": self.folder, "start_new_session": True,
                "env": dict(os.environ, PYTHONPATH=path, PYTHONSAFEPATH="1")}


def analyse(name, task):
    """The task that Dask runs: see `AnalysisServers.analyse`."""
    return get_worker().plugins[name].analyse(task)


async def software(name, dask_worker):
    """The function that Dask runs once on every worker: `AnalysisServers.software` as JSON."""
    loop = asyncio.get_running_loop()
    return json.dumps(await loop.run_in_executor(None, dask_worker.plugins[name].software))
