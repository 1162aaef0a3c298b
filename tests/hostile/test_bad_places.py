# SPDX-License-Identifier: LGPL-2.1-or-later
"""A disk that is full, a share that goes away, a clock that goes backwards."""

import json
import os
import shutil
import subprocess
import sys
import time

import pytest
from program import ROOT, SAMPLES, environment, records, thinpart

FULL = """
mount -t tmpfs -o size={size} tmpfs "$1" && cp "$2" "$1"/first.step && cp "$2" "$1"/second.step || exit 99
"$3" -m thinpart_workbench classify "$1" --no-thumbnails --json
status=$?
ls -A "$1" >&2
exit $status
"""

VANISHING = """
mount -t tmpfs tmpfs "$1" || exit 99
for number in $(seq 40); do cp "$2" "$1"/$number.step; done
"$3" -m thinpart_workbench classify "$1" --json --jobs 2 &
run=$!
while [ ! -e "$1"/1.step.thinpart.json ]; do sleep 0.05; done
umount -l "$1"
wait $run
"""


def in_own_mounts(script, *arguments):
    """Run a shell script that may mount and unmount, which nobody else sees."""
    run = subprocess.run(["unshare", "-m", "sh", "-c", script, "sh", *map(os.fspath, arguments)], capture_output=True,
                         encoding="utf-8", stdin=subprocess.DEVNULL, env=environment(), cwd=ROOT)
    if run.returncode == 99 or "unshare" in run.stderr:
        pytest.skip("this user may not mount")
    assert "Traceback" not in run.stderr + run.stdout, run.stderr
    return run


@pytest.fixture
def place(tmp_path):
    """An empty folder to mount on."""
    folder = tmp_path / "share"
    folder.mkdir()
    return folder


def test_a_full_disk_is_a_row_and_leaves_nothing_half_written(place):
    sample = SAMPLES / "plate.step"
    run = in_own_mounts(FULL.format(size=2 * (sample.stat().st_size // 4096 + 1) * 4096), place, sample, sys.executable)
    rows = records(run)
    errors = [each["error"] for each in rows if "error" in each]
    assert [each["kind"] for each in errors] == ["info_write"] * 2, rows
    assert all("No space left on device" in each["message"] for each in errors)
    assert sum("category" in each for each in rows) == 2 and run.returncode == 1
    left = [line for line in run.stderr.splitlines() if line and not line.startswith(("{", "thinpart:"))]
    assert left == ["first.step", "second.step"]


def test_a_share_that_goes_away_costs_the_rest_a_row_each(place):
    run = in_own_mounts(VANISHING, place, SAMPLES / "plate.step", sys.executable)
    rows = records(run)
    named = {os.path.basename(each["file"]) for each in rows}
    assert named == {f"{number}.step" for number in range(1, 41)}
    kinds = {each["error"]["kind"] for each in rows if "error" in each}
    # That which was being read just then may be called unreadable.
    assert kinds and kinds <= {"missing", "info_write", "unreadable"}, kinds
    assert os.listdir(place) == []  # and not below the place of the share
    assert any("category" in each for each in rows) and run.returncode == 1


def test_a_report_onto_a_full_disk_says_so(place):
    script = ('mount -t tmpfs -o size=60k tmpfs "$1" || exit 99\n'
              '"$3" -m thinpart_workbench report "$2" --output "$1"/report')
    run = in_own_mounts(script, place, SAMPLES / "plate.step", sys.executable)
    assert run.returncode == 1 and "No space left on device" in run.stderr


def test_a_clock_that_goes_backwards_hides_no_change(library):
    """Info files and documents of the future, and newer ones that are older."""
    info = library / "plate.step.thinpart.json"
    future = time.time() + 10 * 365 * 86400
    os.utime(info, (future, future))
    found = records(thinpart("find", library, "--json"))
    assert [each["category"] for each in found] == ["thin"]
    content = json.loads(info.read_text(encoding="utf-8"))
    content["parts"][0]["category"] = "thix"
    # Of the same size, under the same number in the file system, and ten years older.
    with open(info, "r+", encoding="utf-8") as file:
        json.dump(content, file, indent=1)
    os.truncate(info, info.stat().st_size)
    os.utime(info, (future - 11 * 365 * 86400,) * 2)
    assert [each["category"] for each in records(thinpart("find", library, "--json"))] == ["thix"]


def test_a_document_that_is_older_than_its_info_file_says_is_measured_anew(library):
    document = library / "plate.step"
    before = document.stat().st_mtime
    shutil.copyfile(SAMPLES / "block.step", document)
    os.utime(document, (before - 86400, before - 86400))
    run = thinpart("classify", library, "--json")
    assert [each["category"] for each in records(run)] == ["normal"]
