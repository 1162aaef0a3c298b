# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each process beside the window says comes to the window as messages: worker, JSON, German."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from made_library import PAPER, record_of, store
from program import ROOT, SAMPLES, environment

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.message import Message, message, restored, with_messages
from thinpart_workbench.storage.info.info_file import info_path, read_info

GERMAN = ROOT / "resources" / "translations" / "ThinPart_de.qm"


@pytest.fixture
def german(freecad):
    """Says a sentence as the window does in German, which has to know it."""
    from thinpart_workbench.gui.application.qt import QtCore
    from thinpart_workbench.gui.application.sentences import translated

    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    translator = QtCore.QTranslator()
    assert translator.load(str(GERMAN))
    application.installTranslator(translator)

    def say(sentence):
        assert isinstance(sentence, Message) and translated(sentence) != sentence, repr(sentence)
        return translated(sentence)

    yield say
    application.removeTranslator(translator)


class Worker:
    """A process of `window_processes`, asked and answering as the window's are."""

    def __init__(self, module):
        self.process = subprocess.Popen(
            [sys.executable, "-m", f"thinpart_workbench.window_processes.{module}"], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, env=environment())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.stdout.read()
        self.process.wait()
        self.process.stdout.close()

    def ask(self, **request):
        self.process.stdin.write(json.dumps(with_messages(request)).encode() + b"\n")
        self.process.stdin.flush()

    def call(self, function, **arguments):
        self.ask(ask=function, arguments=arguments, preferred={})

    def told(self, key):
        """What the next line that has this key says."""
        for line in self.process.stdout:
            content = restored(json.loads(line))
            if key in content:
                return content[key]
        raise AssertionError(f"no line with {key}")


def damaged(folder):
    folder.mkdir(exist_ok=True)
    file = folder / "damaged.step.thinpart.json"
    file.write_text("{}")
    return file


NOT_AN_INFO_FILE = "damaged.step.thinpart.json ist keine Infodatei von ThinPart."


def test_the_process_that_measures(freecad, tmp_path, german):
    import numpy as np
    import Part

    from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
    from thinpart_workbench.freecad_adapter.shapes.part import MeshedPart, SolidPart

    older = message("'{object}' has an empty shape: recompute the document or delete it.", object="Pad")
    parts = [SolidPart("Small", "Small", [None], (older,), Part.makeBox(0.04, 0.04, 0.01)),
             MeshedPart("Empty", "Empty", [None], (), np.zeros((3, 3)), np.zeros((0, 3), dtype=np.int64))]
    for _ in write_snapshot(parts, str(tmp_path), AnalysisSettings(), PAPER.content):
        pass
    with Worker("snapshot_worker") as worker:
        worker.ask(folder=str(tmp_path), megabytes=6144)
        warnings = [german(each) for each in worker.told("record")["warnings"]]
        assert german(worker.told("failure")["message"]) == "Es enthält keine Dreiecke."
    assert warnings[0].startswith("„Pad“ hat eine leere Form:")
    assert warnings[1].startswith("Das Bauteil misst 0.0574\u00a0mm in der Diagonale:")


def test_the_process_that_classifies_what_was_saved(freecad, tmp_path, german):
    document = freecad.newDocument("Empty")
    document.saveAs(str(tmp_path / "empty.FCStd"))
    freecad.closeDocument(document.Name)
    job = {"folder": "", "settings": AnalysisSettings().content(), "profile": "paper", "seconds": 300,
           "megabytes": 6144}
    with Worker("request_worker") as worker:
        worker.call("saved_documents.classify_saved", document=str(tmp_path / "empty.FCStd"), **job)
        assert german(worker.told("answer")["no_part"]) == "empty.FCStd ist ein leeres Dokument."
        worker.call("saved_documents.classify_saved", document=str(tmp_path / "empty.FCStd"), **{**job, "profile": "none"})
        assert german(worker.told("refused")).startswith("Das Profil 'none' gibt es nicht:")


def test_the_process_that_writes_info_files(tmp_path, german):
    document = shutil.copy(SAMPLES / "plate.FCStd", tmp_path / "plate.FCStd")
    sentence = message("Its surface encloses no volume.")
    failure = {"part": "Solid2", "label": "x", "kind": "zero_volume", "message": sentence}
    status = os.stat(document)
    job = {"document": str(document), "folder": "", "settings": AnalysisSettings().content(), "profile": PAPER.content,
           "records": [record_of("plate")], "failures": [failure]}
    with Worker("request_worker") as worker:
        worker.call("document_info.write_document_info", **job, stamp=[status.st_size, 1])
        assert german(worker.told("refused")).startswith("plate.FCStd wurde inzwischen")
        worker.call("document_info.write_document_info", **job, stamp=[status.st_size, status.st_mtime_ns])
        assert worker.told("answer")["path"] == str(info_path(document))
    told = read_info(info_path(document))["failures"][0]["message"]
    assert told == sentence and german(told) == "Die Oberfläche umschließt kein Volumen."


def test_the_process_that_searches_libraries(tmp_path, german, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    file, gone = damaged(tmp_path / "library"), tmp_path / "gone"
    with Worker("library_worker") as worker:
        worker.ask(ask="open", roots=[str(tmp_path / "library"), str(gone)])
        states = worker.told("libraries")
        while any(each["busy"] for each in states):
            states = worker.told("libraries")
        assert german(states[1]["problems"][0]).startswith(f"Den Ordner {gone} gibt es nicht mehr:")
        worker.ask(ask="find", serial=1, query={"conditions": "D9 > 6"})
        found = worker.told("found")
        assert german(found["refusal"]).startswith("Die Größe 'D9' in der Bedingung 'D9 > 6' gibt es nicht:")
        assert german(found["rows"][0]["error_message"]) == NOT_AN_INFO_FILE
        worker.ask(ask="record", info_file=str(file), name="Solid1")
        assert german(worker.told("record")["sentence"]) == NOT_AN_INFO_FILE
        worker.ask(ask="keep", root=str(tmp_path), info_file=str(file), name="Solid1", notes=None, mesh="{", link=None)
        assert german(worker.told("kept")["sentence"]).startswith("Die Netzeinstellungen")


def test_the_process_that_judges_again(tmp_path, german):
    damaged(tmp_path / "library")
    store(tmp_path / "library", "plate.step", [record_of("plate")])
    with Worker("judging_worker") as worker:
        worker.ask(ask="open", roots=[str(tmp_path / "library")])
        worker.ask(ask="judge", serial=1, profile=PAPER.content)
        while (counted := worker.told("counted"))["read"] < counted["total"]:
            pass
        assert [german(each) for each in counted["problems"]] == [NOT_AN_INFO_FILE]
        worker.ask(ask="write", profile=PAPER.content)
        while not (written := worker.told("written"))["ended"]:
            pass
        assert [german(each) for each in written["problems"]] == [NOT_AN_INFO_FILE]


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "empty.step").touch()
    (tmp_path / "tiny.stl").write_bytes(b"solid x\nfacet normal 0 0 1\nouter loop\n" + b"vertex 0 0 0\n" * 3)
    return tmp_path


def test_the_command_that_classifies_folders(folder, german, start):
    _, lines, _, _ = start(folder, "--json", "--control", "--no-info").end()
    told = {Path(line["file"]).name: restored(line)["error"]["message"] for line in lines}
    assert german(told["empty.step"]) == "empty.step ist leer (0 Byte)."
    assert german(told["tiny.stl"]) == "tiny.stl ist abgeschnitten: Das Ende fehlt."
    assert all(line["error"]["message"] == told[Path(line["file"]).name] for line in lines)


def test_a_file_that_is_unchanged(freecad, tmp_path, german, start):
    import Mesh

    box = Mesh.createBox(10, 10, 10)
    box.removeFacets([0])
    box.write(str(tmp_path / "open.off"))
    for _ in range(2):
        _, (line,), told, _ = start(tmp_path, "--json", "--control", "--profile", "paper").end()
        warnings = restored(line)["warnings"]
        assert [german(each) for each in warnings] == [
            "Die Oberfläche ist offen (3 freie Kanten), daher ist das Volumen nicht sicher."]
        assert german(restored(line)["reason"]).startswith("V/VBB konnte nicht gemessen werden")
    assert told[-1]["progress"]["reused"] == 1


def test_other_readers_of_its_lines_get_what_they_always_got(folder, start):
    _, lines, _, _ = start(folder, "--json", "--no-info").end()
    assert len(lines) == 2 and {key for line in lines for key in line} <= {"file", "error", "confinement"}


def test_why_the_command_refuses(tmp_path, german, start):
    _, _, told, sentences = start(tmp_path, "--json", "--control").end()
    failure = restored(told[-1])["failure"]
    assert sentences == [f"thinpart: {failure['message']}"] and failure["kind"] == "empty"
    assert german(failure["message"]).startswith(f"In {tmp_path} gibt es keine Bauteile:")
