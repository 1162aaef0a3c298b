# SPDX-License-Identifier: LGPL-2.1-or-later
"""The study of agreement runs on a folder of labelled parts."""

import csv
import shutil
import subprocess
import sys

from program import ROOT, environment

SAMPLES = ROOT / "resources" / "samples"

LABELS = (
    ("plate", "one", "thin", ""), ("tube", "two", "thin", ""), ("bent_sheet_bracket", "three", "thin", "thin_features"),
    ("gear_thin_teeth", "one", "thin_features", ""), ("spur_gear_on_hub", "two", "thin_features", "normal"),
    ("block", "three", "normal", ""), ("shaft", "two", "normal", ""), ("vee_block", "one", "thin", ""),
)
"""Sample, repository, label, second answer. The last one is wrong on purpose."""


def test_it_says_how_often_verdicts_and_labels_agree(tmp_path):
    with (tmp_path / "manifest.csv").open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(["file", "source_repo", "expert_label", "confidence", "alt_label"])
        for name, repository, label, second in LABELS:
            shutil.copy(SAMPLES / f"{name}.step", tmp_path)
            table.writerow([f"{name}.step", repository, label, "" if second else "sure", second])
    run = subprocess.run(
        [sys.executable, ROOT / "benchmarks" / "agreement.py", "--parts", tmp_path, "--info-dir", tmp_path / "info",
         "--markdown"],
        env=environment(), capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)
    assert run.returncode == 0, run.stderr
    lines = run.stdout.splitlines()
    assert lines[0] == "Agreement, 8 parts of 3 repositories"
    # Of six sure ones the vee block is wrong, and of all eight too, since the gear's second answer is right.
    assert "| this profile | 83.3 % | 87.5 % | 2 of 3 | 0 of 2 |" in lines
    assert any(line.startswith("| chosen without the repository | ") for line in lines)
    assert "| thin | 2 | 0 | 1 | 0 |" in lines and "| normal | 0 | 0 | 2 | 0 |" in lines
    assert any(line.startswith("Stated probability, chosen without the repository; ") for line in lines)
    assert len(list((tmp_path / "info").glob("*.thinpart.json"))) == len(LABELS)


def test_without_a_table_of_labels_it_says_what_to_do(tmp_path):
    run = subprocess.run([sys.executable, ROOT / "benchmarks" / "agreement.py", "--parts", tmp_path], env=environment(),
                         capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL)
    assert run.returncode == 2
    assert run.stderr == "There is no folder with a manifest.csv: name one with --parts.\n"
