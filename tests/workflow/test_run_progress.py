# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time left: from the bytes that were measured, not from what was only looked up."""

import pytest

from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.workflow.analysis import run_progress
from thinpart_workbench.workflow.analysis.run_progress import RunProgress

LARGE = 10_000_000


def files(**sizes):
    return {name: (size, name.startswith("old")) for name, size in sizes.items()}


def measured(file, seconds):
    return {"file": file, "parts": [], "failures": [], "reused": False, "seconds": seconds}


def reused(file):
    return {**measured(file, 0.001), "reused": True}


def test_there_is_no_time_left_before_there_is_a_basis():
    progress = RunProgress(files(a=LARGE, b=LARGE, c=LARGE, d=3 * LARGE, old1=1, old2=1), 2)
    assert progress.content() == {"done": 0, "total": 6, "failed": 0, "reused": 0, "seconds": 0.0,
                                  "seconds_left": None, "file": None}
    progress.add(reused("old1"))
    progress.add(reused("old2"))
    assert progress.seconds_left() is None
    progress.add(measured("a", 10.0))
    assert progress.seconds_left() == pytest.approx(25.0, rel=0.02)
    progress.add({"file": "b", "error": {"kind": "crash", "message": ""}})
    progress.add(measured("c", 10.0))
    content = progress.content("c")
    assert content["seconds_left"] == pytest.approx(30.0, rel=0.02)
    assert (content["done"], content["failed"], content["reused"], content["file"]) == (5, 1, 2, "c")
    progress.add(measured("d", 30.0))
    assert progress.seconds_left() == 0.0


def test_one_small_file_of_many_is_no_basis_for_all_workers():
    many = {f"{number}": (1000, False) for number in range(100)}
    progress = RunProgress(many, 4)
    for number in range(3):
        progress.add(measured(f"{number}", 1.0))
        assert progress.seconds_left() is None
    progress.add(measured("3", 1.0))
    assert progress.seconds_left() == pytest.approx(96 / 4)


def test_small_files_cost_something_too():
    progress = RunProgress({"large": (LARGE, False), **{f"{k}": (0, False) for k in range(1000)}}, 1)
    progress.add(measured("large", 10.0))
    assert 10 < progress.seconds_left() < 100


def test_info_files_of_other_settings_are_counted_as_measured_once_that_shows():
    progress = RunProgress({f"old{k}": (LARGE, True) for k in range(40)}, 1)
    for number in range(30):
        progress.add(measured(f"old{number}", 5.0))
    assert progress.seconds_left() == pytest.approx(50.0)


def test_where_everything_is_looked_up_the_pace_of_that_counts():
    progress = RunProgress({f"old{k}": (LARGE, True) for k in range(1000)}, 1)
    for number in range(20):
        assert progress.seconds_left() is None
        progress.add(reused(f"old{number}"))
    assert 0 < progress.seconds_left() < 900
    few = RunProgress({f"old{k}": (LARGE, True) for k in range(3)}, 1)
    few.add(reused("old0"))
    assert few.seconds_left() is None
    few.add(reused("old1"))
    assert few.seconds_left() >= 0


def test_failures_of_a_part_count_once_by_file():
    progress = RunProgress(files(a=1), 1)
    progress.add({**measured("a", 1.0), "failures": [{}, {}]})
    assert progress.failed == 1


def test_large_files_take_what_large_files_took():
    """Five large files beside 95 small ones: bytes alone would have them as quick as the small ones."""
    sizes = {f"small{k}": (10_000, False) for k in range(95)} | {f"large{k}": (LARGE, False) for k in range(5)}
    progress = RunProgress(sizes, 1)
    for number in range(40):
        progress.add(measured(f"small{number}", 0.5))
    before = progress.seconds_left()
    progress.add(measured("large0", 600.0))  # slower per byte than the small ones
    assert progress.seconds_left() == pytest.approx(4 * 600.0 + 55 * 0.5, rel=0.1)
    assert before > 4 * 60.0  # by bytes, where no large file is known yet
    for number in range(1, 5):
        progress.add(measured(f"large{number}", 600.0))
    assert progress.seconds_left() == pytest.approx(55 * 0.5, rel=0.2)


def test_what_is_not_done_yet_counts(monkeypatch):
    """Of eight equal-looking files two end soon; the workers sit on others for a minute."""
    now, control = [0.0], RunControl()
    monkeypatch.setattr(run_progress.time, "monotonic", lambda: now[0])
    progress = RunProgress({f"{k}": (LARGE, False) for k in range(8)}, 2, control)
    now[0] = 4.0
    progress.add(measured("0", 4.0))
    progress.add(measured("1", 4.0))
    assert progress.seconds_left() == pytest.approx(12.0, rel=0.05)
    now[0] = 64.0
    assert progress.seconds_left() > 180.0
    control.set_state("paused")
    now[0] = 1064.0
    control.set_state("running")
    assert progress.seconds_left() < 240.0
