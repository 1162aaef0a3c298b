# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart as a library in FreeCAD's own process, as its Python console calls it."""

import FreeCADGui as Gui
from program import SAMPLES

from thinpart_workbench.freecad_adapter.python_beside_freecad import is_within_freecad


def typed(*lines):
    """What lines that are typed into the console leave in ``answer``."""
    import __main__

    for line in ("import thinpart_workbench as thinpart", *lines):
        Gui.doCommand(line)
    return __main__.__dict__.pop("answer")


def test_a_file_is_read_by_the_python_beside_freecad():
    assert is_within_freecad(), "FreeCAD is no Python that could start a worker by itself"
    part, = typed(f"answer = thinpart.classify({str(SAMPLES / 'tube.step')!r})")
    assert (part.label, part.category) == ("tube", "thin")


def test_a_file_that_is_damaged_is_one_sentence(tmp_path):
    (tmp_path / "damaged.step").write_bytes(b"ISO-10303-21;" + b"\0" * 1000)
    answer, = typed(f"answer = list(thinpart.classify_files({str(tmp_path)!r}))")
    assert len(answer) == 0 and answer.failures[0].kind == "unreadable"


def test_what_is_open_is_measured_at_once(document):
    lid = document.addObject("Part::Box", "Lid")
    lid.Length, lid.Width, lid.Height = 100, 80, 2
    document.recompute()
    part, = typed("answer = thinpart.classify(App.ActiveDocument.Lid)")
    assert (part.label, part.category) == ("Lid", "thin") and part.measurement is not None
    part, = typed("answer = thinpart.classify(App.ActiveDocument)")
    assert part.instances == 1
