# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comparing the documents of two parts, as work for a cluster."""

import os
from contextlib import contextmanager

import numpy as np

from ...core.forms.motion import Motion
from ...core.forms.recorded_form import form_of_record, recorded_form
from ..analysis.analysis_outcome import told_failure
from ..cluster.cluster_work import ClusterWork
from ..workers.task_run import Done, task_workers
from .comparison_task import ComparedPart, ComparisonTask, checked_comparison, comparison_by_worker


def _content(task):
    motions = [{"turn": motion.turn.tolist(), "scale": float(motion.scale), "shift": motion.shift.tolist()}
               for motion in task.motions]
    return {"part": _part_content(task.part), "reference": _part_content(task.reference), "motions": motions}


def _part_content(part):
    # What is packed was unpacked from an index, and comes out the same again.
    return {"file": os.path.abspath(part.file), "sha256": part.sha256, "name": part.name,
            "area_mm2": float(part.form.moments.area), "form": recorded_form(part.form)}


def _task(content):
    motions = tuple(Motion(np.array(motion["turn"]), motion["scale"], np.array(motion["shift"]))
                    for motion in content["motions"])
    return ComparisonTask(_part(content["part"]), _part(content["reference"]), motions)


def _part(content):
    form = form_of_record({"form": content["form"], "descriptors": {"area_mm2": content["area_mm2"]}})
    return ComparedPart(content["file"], content["sha256"], content["name"], form)


@contextmanager
def _comparer(limits):
    with task_workers(1, comparison_by_worker, checked_comparison, limits) as run:
        def compare(task, control):
            done, = run([task], control)
            return done.failure or done.result

        yield compare


def _done(task, outcome):
    failed = told_failure(task, outcome)
    return Done(task, failure=failed) if failed is not None else Done(task, checked_comparison(task, outcome))


COMPARISONS = ClusterWork("reuse.comparison_work.COMPARISONS", _content, _task, _comparer, _done,
                          lambda task: [task.part.file, task.reference.file])
"""Its tasks are `ComparisonTask`, its results as `comparison_task.ANSWER`."""
