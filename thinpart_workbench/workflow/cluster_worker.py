"""What runs inside a Dask worker. It travels there as code, so it imports nothing of ThinPart.

The package itself travels as an archive that every worker unpacks: machines need Debian's packages, but no
ThinPart, and all have the version of whoever started the run.
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

_SERVER = "thinpart_workbench.workflow.analysis_server"
_SECONDS_TO_END = 10


class AnalysisServers(WorkerPlugin):
    """The processes of one Dask worker that analyse files: one per thread that asks.

    Parameters
    ----------
    name : str
        Of this plugin; another one for every run.
    archive : bytes
        A ZIP archive of ThinPart.
    limits : str
        JSON: what one file may cost.
    """

    def __init__(self, name, archive, limits):
        self.name, self.archive, self.limits = name, archive, limits

    def setup(self, worker):
        """Unpack ThinPart; called by Dask, also on workers that come later."""
        self.lock = threading.Lock()
        self.all, self.idle, self.closed, self.known = [], [], False, None
        self.folder = tempfile.mkdtemp(prefix="thinpart-", dir=worker.local_directory)
        with zipfile.ZipFile(io.BytesIO(self.archive)) as archive:
            archive.extractall(self.folder)

    def teardown(self, worker):
        """End the processes, also in the middle of a file; called by Dask."""
        with self.lock:
            self.closed = True
            servers = list(self.all)
        for server in servers:
            server.stdin.close()
        # Dask waits in its event loop meanwhile.
        threading.Thread(target=self._clear, args=(servers,)).start()

    def _clear(self, servers):
        for server in servers:
            try:
                server.wait(_SECONDS_TO_END)
            except subprocess.TimeoutExpired:
                server.kill()
        shutil.rmtree(self.folder, ignore_errors=True)

    def software(self):
        """Versions, or what is lacking, and the name of the machine; looked up once."""
        with self.lock:
            if self.known is None:
                run = subprocess.run(
                    [sys.executable, "-m", _SERVER, "--check"], stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, **self._place())
                try:
                    self.known = json.loads(run.stdout)
                except ValueError:
                    last = run.stderr.decode(errors="replace").strip().splitlines()[-1:]
                    self.known = {"lacks": f"ThinPart does not start there ({' '.join(last)})"}
                self.known["host"] = socket.gethostname()
            return self.known

    def analyse(self, task):
        """Analyse one file.

        Parameters
        ----------
        task : str
            A line of JSON.

        Returns
        -------
        dict
            ``software``, and ``outcome``: a line of JSON; None where the process ended.
        """
        known = self.software()
        if "lacks" in known:
            return {"software": known, "outcome": None}
        line = b""
        for _ in range(2):
            server = self._take()
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
                # This worker is about to go; the file is somebody else's.
                raise Reschedule()
            if server.wait():
                break
            # It had ended by itself, after having been idle: another one.
        return {"software": known, "outcome": line.decode() or None}

    def _take(self):
        with self.lock:
            while self.idle:
                server = self.idle.pop()
                if server.poll() is None:
                    return server
            if self.closed:
                raise Reschedule()
            self.all = [each for each in self.all if each.poll() is None]
            server = subprocess.Popen(
                [sys.executable, "-m", _SERVER, self.limits], stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, **self._place())
            self.all.append(server)
            return server

    def _place(self):
        path = os.pathsep.join(filter(None, (self.folder, os.environ.get("PYTHONPATH"))))
        # Ctrl-C in the terminal of a Dask worker is its own business.
        return {"cwd": self.folder, "start_new_session": True,
                "env": dict(os.environ, PYTHONPATH=path, PYTHONSAFEPATH="1")}


def analyse(name, task):
    """The task that Dask runs: see `AnalysisServers.analyse`."""
    return get_worker().plugins[name].analyse(task)


async def software(name, dask_worker):
    """What Dask runs once on every worker: see `AnalysisServers.software`."""
    loop = asyncio.get_running_loop()
    return await loop.run_in_executor(None, dask_worker.plugins[name].software)
