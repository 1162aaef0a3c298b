# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analysing files, as work for a cluster."""

import os
from dataclasses import asdict

from ...core.analysis_settings import AnalysisSettings
from ..analysis.analyse_file import FileTask
from ..analysis.analysis_outcome import checked_outcome
from ..workers.task_run import Done
from ..workers.worker_pool import file_analyser
from .cluster_work import ClusterWork


def _content(task):
    content = asdict(task)
    for key in ("file", "info_file"):
        if content[key] is not None:
            content[key] = os.path.abspath(content[key])
    return content


def _task(content):
    return FileTask(**{**content, "settings": AnalysisSettings(**content["settings"])})


def _done(task, outcome):
    outcome = checked_outcome(task, outcome)
    return Done(task, failure=outcome) if "error" in outcome else Done(task, outcome)


FILES = ClusterWork("cluster.file_work.FILES", _content, _task, file_analyser, _done, lambda task: [task.file])
"""Its tasks are `FileTask`, its results outcomes of `worker_pool.analyse_files`."""
