# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result depends on besides the program: the machine and the versions."""

import os
import platform
import subprocess

from .places import ROOT


def machine():
    """dict: ``cpu``, ``cores``, ``memory_gb`` and ``os``; nothing that names the machine itself."""
    pages = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return {
        "cpu": _value("/proc/cpuinfo", "model name", ":") or platform.machine(),
        "cores": len(os.sched_getaffinity(0)),
        "memory_gb": round(pages / 2 ** 30, 1),
        "os": (_value("/etc/os-release", "PRETTY_NAME", "=") or platform.system()).strip('"'),
        "kernel": platform.release().split("-")[0],
    }


def product_version():
    """dict: ``ThinPart``, and ``commit``, with a plus sign where files differ from it, if git knows."""
    from thinpart_workbench import __version__

    commit = _git("rev-parse", "--short=12", "HEAD")
    changed = commit and _git("status", "--porcelain", "--", "thinpart_workbench", "thinpart")
    return {"ThinPart": __version__, "commit": commit and commit + ("+" if changed else "")}


def _value(file, key, separator):
    try:
        with open(file, encoding="utf-8") as lines:
            for line in lines:
                name, _, value = line.partition(separator)
                if name.strip() == key:
                    return value.strip()
    except OSError:
        pass
    return None


def _git(*arguments):
    try:
        run = subprocess.run(["git", "-C", str(ROOT), *arguments], capture_output=True, text=True,
                             stdin=subprocess.DEVNULL)
    except OSError:
        return None
    return run.stdout.strip() if run.returncode == 0 else None
