# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of parts that look like lengths stand in sentences and pages as they are, in every unit and language."""

import html
import json
import re

import pytest
from program import thinpart

from thinpart_workbench.core.judging.wall_check import check_sentence, check_walls
from thinpart_workbench.core.judging.wall_limits import WallLimits
from thinpart_workbench.core.length_unit import INCH
from thinpart_workbench.core.message import restored, with_messages
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.workflow.report.page_language import page_language

NAMES = ("lid 3 mm.step", "lid 3.5 mm.step", "v1.25 of 0.5 % 2.5 mm (1).step")


def test_a_report_in_inches_has_the_names_of_files_as_they_are(tmp_path):
    parts = tmp_path / "parts 1.5 mm"
    parts.mkdir()
    for name in NAMES:
        (parts / name).touch()
    run = thinpart("report", parts, "--output", tmp_path / "report", "--unit", "in", "--language", "de")
    assert run.returncode == 1, run.stderr
    page = html.unescape((tmp_path / "report" / "index.html").read_text(encoding="utf-8")).replace("\u00a0", " ")
    for name in NAMES:
        assert page.count(name) >= 2, "as a file, and in the sentence about it"
    assert not re.search(r"\d in\.step|lid \d,|lid 0[.,]|v1,25|1,5 mm", page)


@pytest.mark.parametrize("language, lengths", [("en", ("0.394", "0.315")), ("de", ("0,394", "0,315"))])
def test_a_check_has_the_title_of_the_process_and_the_face_as_they_are(library, language, lengths):
    record, = read_info(library / "plate.step.thinpart.json")["parts"]
    limits = WallLimits("rule", "Rule of 3.5 mm", 10.0, None)
    line = json.loads(json.dumps(with_messages({"sentence": check_sentence(check_walls(record, limits))})))
    told = page_language(language, INCH).sentence(restored(line)["sentence"])
    assert told.startswith("Rule of 3.5 mm: ") and all(f"{each}\u00a0in" in told for each in lengths), told
