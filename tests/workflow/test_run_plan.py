# SPDX-License-Identifier: LGPL-2.1-or-later
"""The order of a run, and what is known before anything is read."""

import os
from pathlib import Path

from thinpart_workbench.storage.info.info_file import info_path_getter
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.analysis.find_documents import Document
from thinpart_workbench.workflow.analysis.run_plan import plan_run


def plan(documents, jobs, info=lambda file: None, force=False):
    def new_task(file, info_file):
        return FileTask(file, info_file, force=force)

    return plan_run(documents, new_task, info, jobs)


def order(planned):
    return [Path(each.task.file).name for each in planned]


def test_largest_first_where_several_are_at_work():
    documents = [Document(f"/{name}", size, 0.0) for name, size in
                 (("a", 10), ("b", 30), ("c", 20), ("d", 30))]
    assert order(plan(documents, 2)) == ["b", "d", "c", "a"]
    assert order(plan(documents, 1)) == ["a", "b", "c", "d"]


def test_what_is_only_looked_up_comes_first(tmp_path):
    documents = []
    for name, size, time in (("a", 10, 100), ("b", 30, 100), ("c", 20, 300), ("d", 40, 100)):
        documents.append(Document(str(tmp_path / name), size, time))
        if name != "d":
            info = tmp_path / f"{name}.thinpart.json"
            info.write_text("")
            os.utime(info, (200, 200))
    place = info_path_getter()
    assert order(plan(documents, 2, place)) == ["a", "b", "d", "c"]
    assert order(plan(documents, 1, place)) == ["a", "b", "c", "d"]
    assert [each.unchanged for each in plan(documents, 1, place)] == [True, True, False, False]
    assert order(plan(documents, 2, place, force=True)) == ["d", "b", "c", "a"]


def test_a_name_without_room_for_the_ending_is_known_before(tmp_path):
    limit = os.pathconf(tmp_path, "PC_NAME_MAX") - len(".thinpart.json")
    for length, fits in ((limit, True), (limit + 1, False)):
        name = "x" * (length - 5) + ".step"
        each, = plan([Document(str(tmp_path / "new" / name), 1, 1.0)], 1, info_path_getter())
        assert (each.problem is None) == fits and (each.task.info_file is not None) == fits
    assert each.problem.kind == "info_write" and str(limit) in str(each.problem)
    each, = plan([Document(str(tmp_path / ("ü" * 120 + ".step")), 1, 1.0)], 1, info_path_getter())
    assert each.problem is not None and "245" in str(each.problem)
