# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that makes the bundled samples."""

import json
import subprocess
import sys

import pytest
from program import SAMPLES

from thinpart_workbench.freecad_adapter.reading.part_files import read_parts


def make_samples(*arguments):
    return subprocess.run([sys.executable, SAMPLES / "make_samples.py", *map(str, arguments)],
                          capture_output=True, encoding="utf-8")


def test_a_sample_is_made_as_it_is_bundled(tmp_path):
    run = make_samples("--out", tmp_path, "--only", "plate")
    assert run.returncode == 0, run.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["plate.FCStd", "plate.step"]
    for path in tmp_path.iterdir():
        (made,), (bundled,) = read_parts(path).parts, read_parts(SAMPLES / path.name).parts
        assert made.label == bundled.label and len(made.shape.Faces) == len(bundled.shape.Faces)
        assert made.shape.Volume == pytest.approx(bundled.shape.Volume, rel=1e-9)


def test_an_unknown_sample_is_said(tmp_path):
    run = make_samples("--out", tmp_path / "new", "--only", "plate", "plaet")
    assert run.returncode == 2 and run.stderr.endswith("no such sample: plaet\n")
    assert not (tmp_path / "new").exists()


def test_the_list_beside_the_samples_is_the_table(monkeypatch):
    monkeypatch.syspath_prepend(SAMPLES)
    from sample_parts.table import SAMPLES as TABLE

    listed = json.loads((SAMPLES / "samples.json").read_text(encoding="utf-8"))
    assert [sample.content() for sample in TABLE] == listed
