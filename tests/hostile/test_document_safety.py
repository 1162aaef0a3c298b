# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document that is read writes nothing and runs nothing."""

import json
import os
import struct
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from hostile_documents import changed, harmless, with_module, with_resource
from program import failures, records, thinpart

from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.freecad_adapter.reading.document_safety import (
    check_document,
    leaves_its_folder,
    named_modules,
)

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def document(freecad, tmp_path_factory):
    return harmless(freecad, tmp_path_factory.mktemp("harmless") / "harmless.FCStd")


def _classified(*files, **options):
    run = thinpart("classify", "--json", "--no-info", "--no-thumbnails", *files, **options)
    assert "Traceback" not in run.stderr
    return {Path(line["file"]).name: line for line in records(run)}


def _opened_by_freecad(file, folder):
    """Open a document in a process of its own, with nothing of ThinPart's in between."""
    code = ("import sys; sys.path[:0] = {!r}; import FreeCAD, Part; FreeCAD.openDocument({!r}, True)").format(
        [each for each in sys.path if "freecad" in each.lower()], os.fspath(file))
    subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, timeout=60, check=False,
                   env={**os.environ, "PYTHONPATH": os.fspath(folder), "TMPDIR": os.fspath(folder)})


def test_a_harmless_document_is_read(document):
    check_document(document)
    assert named_modules(document).others == ()
    assert _classified(document)["harmless.FCStd"]["category"] == "normal"


def test_no_document_of_other_people_is_refused_for_nothing(training_parts):
    documents = [each for each in training_parts.glob("parts/*") if each.suffix.lower() == ".fcstd"]
    for document in documents:
        check_document(document)
        assert named_modules(document).others == (), document.name
    assert len(documents) > 20


def test_resources_that_leave_their_folder_are_refused(document, tmp_path):
    victim = tmp_path / "victim.step"
    victim.write_text("the user's own")
    stored = ["V/../../../victim.step", "V/../../../../../../../../../../" + os.fspath(victim).lstrip("/")]
    hostile = [changed(document, tmp_path / f"hostile{number}.FCStd", with_resource(each), [(each, b"overwritten")])
               for number, each in enumerate(stored)]
    found = _classified(*hostile)
    for path in hostile:
        assert found[path.name]["error"]["kind"] == "unsafe"
        assert f"{path.name} was not opened" in found[path.name]["error"]["message"]
    assert victim.read_text() == "the user's own"


def test_freecad_alone_would_have_written_there(document, tmp_path):
    """The exploit is a real one: without the check, the file is overwritten."""
    victim = tmp_path / "victim.step"
    victim.write_text("the user's own")
    stored = "V/" + "../" * 12 + os.fspath(victim).lstrip("/")
    hostile = changed(document, tmp_path / "hostile.FCStd", with_resource(stored), [(stored, b"overwritten")])
    _opened_by_freecad(hostile, tmp_path)
    if victim.read_text() == "the user's own":
        pytest.skip("this FreeCAD writes no resource outside the folder of the document")
    assert victim.read_text() == "overwritten"


def test_a_document_that_links_to_a_hostile_one_is_refused(freecad, document, tmp_path):
    target = harmless(freecad, tmp_path / "target.FCStd")
    opened = freecad.openDocument(str(target))
    main = freecad.newDocument("Main")
    main.saveAs(str(tmp_path / "main.FCStd"))
    main.addObject("App::Link", "Link").LinkedObject = opened.Block
    main.recompute()
    main.save()
    freecad.closeDocument(main.Name)
    freecad.closeDocument(opened.Name)
    check_document(tmp_path / "main.FCStd")
    changed(document, target, with_resource("V/../../x"), [("V/../../x", b"")])
    with pytest.raises(ThinPartError, match="target.FCStd was not opened") as error:
        check_document(tmp_path / "main.FCStd")
    assert error.value.kind == "unsafe"


@pytest.fixture(scope="module")
def linking(freecad, tmp_path_factory):
    """A document that links to target.FCStd beside it."""
    folder = tmp_path_factory.mktemp("linking")
    opened = freecad.openDocument(str(harmless(freecad, folder / "target.FCStd")))
    main = freecad.newDocument("Main")
    main.saveAs(str(folder / "main.FCStd"))
    main.addObject("App::Link", "Link").LinkedObject = opened.Block
    main.addObject("Part::Box", "Own")
    main.recompute()
    main.save()
    freecad.closeDocument(main.Name)
    freecad.closeDocument(opened.Name)
    return folder / "main.FCStd"


@pytest.mark.parametrize("written", [
    'file="target.dat"', "file='target.FCStd'", "file = 'target.FCStd'", 'label="a>b" file="target.FCStd"',
    'file="t&#97;rget.FCStd"'])
def test_a_link_to_a_hostile_document_is_found_however_it_is_written(document, linking, tmp_path, written):
    name = "target.dat" if ".dat" in written else "target.FCStd"
    changed(document, tmp_path / name, with_resource("V/../../x"), [("V/../../x", b"")])
    main = changed(linking, tmp_path / "main.FCStd", lambda text: text.replace('file="target.FCStd"', written))
    with pytest.raises(ThinPartError, match=f"{name} was not opened"):
        check_document(main)


def test_a_link_to_what_is_no_document_tells_nothing_about_it(linking, tmp_path):
    """Its hash and size would go to whoever gets the info file."""
    secret = tmp_path / "shadow"
    secret.write_text("root:$6$...")
    main = changed(linking, tmp_path / "main.FCStd",
                   lambda text: text.replace('file="target.FCStd"', f'file="{secret}"'))
    run = thinpart("classify", "--json", "--no-thumbnails", main)
    assert failures(run) == {"main.FCStd": "missing"} and "'Block' in shadow" in run.stderr
    content = json.loads((tmp_path / "main.FCStd.thinpart.json").read_text())
    assert content["source"]["links"] == [{"file": "shadow", "sha256": None, "bytes": None, "modified": None}]
    assert [part["name"] for part in content["parts"]] == ["Own"]


@pytest.mark.parametrize("name", ["/etc/x", "../x", "a/../../x", "..\\x", "C:\\x", "C:x", "\\\\server\\x"])
def test_an_entry_that_leaves_its_folder_is_refused(document, tmp_path, name):
    hostile = changed(document, tmp_path / "hostile.FCStd", entries=[(name, b"")])
    with pytest.raises(ThinPartError, match="was not opened"):
        check_document(hostile)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "cp037", "utf-7", "utf-99999"])
def test_other_encodings_hide_nothing(document, tmp_path, encoding):
    def encoded(text):
        return text.replace("utf-8", encoding, 1).replace("?>", '?><!DOCTYPE x [<!ENTITY y "z">]>', 1)

    hostile = changed(document, tmp_path / "hostile.FCStd", encoded)
    if not encoding.endswith("99999"):
        with zipfile.ZipFile(hostile) as archive:
            content = {name: archive.read(name) for name in archive.namelist()}
        with zipfile.ZipFile(hostile, "w") as archive:
            for name, data in content.items():
                archive.writestr(name, data.decode().encode(encoding) if name == "Document.xml" else data)
    with pytest.raises(ThinPartError) as error:
        check_document(hostile)
    assert error.value.kind == "unsafe"


def test_a_name_in_the_sentence_is_short_and_printable(document, tmp_path):
    name = "../" + "\x01\n\u202e" + "x" * 3000
    with pytest.raises(ThinPartError) as error:
        check_document(changed(document, tmp_path / "hostile.FCStd", entries=[(name, b"")]))
    assert len(str(error.value)) < 300 and str(error.value).isprintable() and r"'../\x01\n\u202exx" in str(error.value)


def test_names_that_only_look_alike_are_fine():
    assert not any(map(leaves_its_folder, ["Part..brp", "a/b.brp", "xy:z", "...", "Box.Shape.brp", ""]))


def test_two_entries_of_one_name_are_refused(document, tmp_path):
    with pytest.warns(UserWarning):
        hostile = changed(document, tmp_path / "hostile.FCStd", entries=[("Document.xml", b"<Document/>")])
    with pytest.raises(ThinPartError, match="two entries"):
        check_document(hostile)


def test_an_entry_that_the_table_hides_is_refused(document, tmp_path):
    """FreeCAD reads one entry after the other; the table of contents at the end may leave some out."""
    content = document.read_bytes()
    with zipfile.ZipFile(document) as archive:
        start = archive.start_dir
    name, data = b"V/../../x", b"hidden"
    hidden = struct.pack("<4s5H3I2H", b"PK\3\4", 20, 0, 0, 0, 0, zipfile.crc32(data), len(data), len(data),
                         len(name), 0) + name + data
    end = content.rindex(b"PK\5\6")
    moved = bytearray(content[:start] + hidden + content[start:])
    struct.pack_into("<I", moved, end + len(hidden) + 16, start + len(hidden))
    hostile = tmp_path / "hostile.FCStd"
    hostile.write_bytes(moved)
    with zipfile.ZipFile(hostile) as archive:
        assert archive.testzip() is None and name.decode() not in archive.namelist()
    with pytest.raises(ThinPartError, match="belong to no entry"):
        check_document(hostile)


def test_entities_are_refused(document, tmp_path):
    hostile = changed(document, tmp_path / "hostile.FCStd", lambda text: text.replace(
        "<Document ", '<!DOCTYPE d [<!ENTITY a "../../x">]>\n<Document ', 1))
    with pytest.raises(ThinPartError, match="entities"):
        check_document(hostile)


def test_modules_that_are_not_freecads_are_not_run(document, tmp_path):
    package = tmp_path / "marker_of_a_module"
    package.mkdir()
    for name in ("__init__", "inner"):
        (package / f"{name}.py").write_text(
            f"open({os.fspath(tmp_path / 'ran')!r}, 'a').write('{name}')\nclass C: pass\n")
    modules = ["marker_of_a_module", "marker_of_a_module.inner", "antigravity", "this"]
    hostile = {module: changed(document, tmp_path / f"{module}.FCStd", with_module(module)) for module in modules}
    found = _classified(*hostile.values(), cwd=tmp_path)
    assert not (tmp_path / "ran").exists()
    for module, path in hostile.items():
        said = found[path.name]
        assert said["category"] == "normal"
        assert any(module.partition(".")[0] in each and "not loaded" in each for each in said["warnings"]), (
            module, json.dumps(said["warnings"]))


def test_a_type_of_a_module_that_is_not_freecads_is_not_run(document, tmp_path, monkeypatch):
    (tmp_path / "marker_of_a_type.py").write_text(f"open({os.fspath(tmp_path / 'ran')!r}, 'a')\n")
    hostile = changed(document, tmp_path / "hostile.FCStd", lambda text: text.replace(
        'type="App::VRMLObject"', 'type="marker_of_a_type::Feature"'))
    monkeypatch.setenv("PYTHONPATH", f"{ROOT}:{tmp_path}")
    with monkeypatch.context() as patch:
        patch.syspath_prepend(tmp_path)
        assert named_modules(hostile).others == ("marker_of_a_type",)
    _classified(hostile, cwd=tmp_path)
    assert not (tmp_path / "ran").exists()


def test_the_parts_own_folder_is_on_no_module_path(document, tmp_path, monkeypatch):
    """An empty entry of PYTHONPATH stands for the folder that the program was started in."""
    (tmp_path / "rich.py").write_text(f"open({os.fspath(tmp_path / 'ran')!r}, 'a')\n")
    changed(document, tmp_path / "part.FCStd")
    environment = dict(os.environ, PYTHONPATH=":", PYTHONSAFEPATH="")
    run = subprocess.run([os.fspath(ROOT / "thinpart"), "classify", "part.FCStd", "--no-info"], cwd=tmp_path,
                         env=environment, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
    assert run.returncode == 0, run.stderr
    assert not (tmp_path / "ran").exists()
