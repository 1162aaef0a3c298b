# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people have is never replaced by an output: every option that names one, against everything that may lie there."""

import argparse
import csv
import importlib
import json
import os
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from program import ROOT, thinpart

from thinpart_workbench.cli import COMMANDS, main
from thinpart_workbench.cli.output_options import FOLDER
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.file_formats import ENDINGS
from thinpart_workbench.core.kinds.file_marks import (
    LABELS,
    LIMITS,
    MAPS,
    PAGE,
    PICTURE,
    PROFILE,
    REPORT,
    SHELLS,
    TABLE,
)
from thinpart_workbench.core.shells.shell_mesh import ShellMesh
from thinpart_workbench.storage.atomic_file import place_new
from thinpart_workbench.storage.exchange.geo_file import write_geo
from thinpart_workbench.storage.exchange.shell_files import write_shell
from thinpart_workbench.storage.output_file import ForeignFile, bears_mark, write_output
from thinpart_workbench.storage.png import png_bytes
from thinpart_workbench.workflow.analysis.drawn_part import DrawnPart
from thinpart_workbench.workflow.report.report_pages import PICTURE_HEIGHT, PICTURE_WIDTH, ReportPages

PACKAGE, SCREENSHOTS = ROOT / "thinpart_workbench", ROOT / "docs" / "screenshots"

READ = {"classify": ["part.step"], "duplicates": ["part.step"], "size": ["part.step"],
        "map": ["part.step"], "report": ["part.step"],
        "learn": ["library", "--labels", "labels.csv"]}
"""What each command with outputs reads: its first file is the input of the tests, the last of `learn`."""

INPUT_OPTIONS = {"--limits", "--labels", "--profile", "--mesh", "--info-dir"}
"""Options that name files which are read, and the folder of info files, which are written by rules of their own."""

ENDING = {id(TABLE): (".csv",), id(LABELS): (".csv",), id(PROFILE): (".json",), id(FOLDER): ("",)}


def parsers():
    """The parser of every command, as the program makes it."""
    for name, (module, _) in COMMANDS.items():
        parser = argparse.ArgumentParser()
        importlib.import_module(f"thinpart_workbench.cli.commands.{module}").add_arguments(parser)
        yield name, parser


def outputs():
    """(command, option, ending that it takes) of all outputs."""
    for name, parser in parsers():
        marks = parser.get_default("outputs") or {}
        for action in parser._actions:  # argparse has no public way to list options
            if action.dest in marks:
                mark = marks[action.dest]
                for ending in mark if isinstance(mark, dict) else ENDING[id(mark)]:
                    yield name, action.option_strings[0], ending


OUTPUTS = list(outputs())


def test_every_option_that_names_a_file_is_an_output_or_an_input():
    found = {option for _, parser in parsers() for action in parser._actions for option in action.option_strings[-1:]
             if isinstance(action.metavar, str) and any(word in action.metavar for word in ("FILE", "DIR"))}
    declared = {action.option_strings[-1] for _, parser in parsers() for action in parser._actions
                if action.dest in (parser.get_default("outputs") or {})}
    assert declared and found == declared | INPUT_OPTIONS
    assert {command for command, _, _ in OUTPUTS} == set(READ)


@pytest.fixture
def place(tmp_path, classified, monkeypatch):
    """A folder with inputs, in which the command runs."""
    shutil.copyfile(classified / "plate.step", tmp_path / "part.step")
    shutil.copytree(classified, tmp_path / "library")
    (tmp_path / "labels.csv").write_text("file,category\nplate.step,thin\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def _foreign(path, _):
    # A file of the same kind, by another program.
    content = {".png": b"\x89PNG\r\n\x1a\nof a camera", ".vtp": b'<?xml version="1.0"?>\n<VTKFile type="PolyData">\n',
               ".ply": b"ply\nformat ascii 1.0\ncomment mine\nend_header\n", ".geo": b"Point(1) = {0, 0, 0};\n",
               ".inp": b"** by hand\n*NODE\n", ".msh": b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n",
               ".unv": b"    -1\n   164\n", ".csv": b"file,part,label,what I think of it\n",
               ".json": b'{"format": "letters"}'}
    path.write_bytes(content.get(path.suffix, b"mine"))


def _hard_link(path, source):
    os.link(source, path)


def _symbolic_link(path, source):
    path.symlink_to(source)


def _link_to_foreign(path, source):
    target = path.with_name(f"theirs{path.suffix}")
    _foreign(target, source)
    path.symlink_to(target)


def _broken_link(path, _):
    path.symlink_to("nothing")


def _pipe(path, _):
    os.mkfifo(path)


def _device(path, _):
    path.symlink_to(os.devnull)


def _loop(path, _):
    path.symlink_to(path.name)


def _info_file(path, source):
    shutil.copyfile(source.parent / "library" / "plate.step.thinpart.json", path)


NEVER = [_hard_link, _symbolic_link, _link_to_foreign, _broken_link, _info_file, _pipe, _device, _loop]


def content_of(folder):
    """Everything below a folder: what each file contains, where each link leads, and which file each name is."""
    return {path: (os.readlink(path) if path.is_symlink() else path.read_bytes() if path.is_file() else None,
                   path.lstat().st_ino) for path in sorted(folder.rglob("*"))}


def bytes_of(folder):
    """The same, whoever wrote it: a mark may be written anew before a picture is refused."""
    return {path: content for path, (content, _) in content_of(folder).items()}


def refused(place, command, option, output, *more):
    """Whether a command refuses an output before it reads anything, and leaves everything as it was; in one sentence."""
    before = content_of(place)
    status = main([command, *READ[command], option, str(output), *more])
    assert content_of(place) == before
    return status == 2


@pytest.mark.parametrize("command, option, ending", OUTPUTS)
def test_nothing_of_the_users_is_replaced(place, capsys, command, option, ending):
    source, output = place / READ[command][-1 if command == "learn" else 0], place / f"out{ending}"
    for make in (_foreign, *NEVER):
        make(output, source)
        for more in [(), ("--overwrite",)][:1 if make is _foreign and ending != ".ply" else 2]:
            assert refused(place, command, option, output, *more), (make, more)
            err = capsys.readouterr().err
            assert err.startswith("thinpart: ") and err.count("\n") == 1 and "out" in err, (make, err)
        output.unlink()
    for name in (source.name, "new.STEP", "part.step.thinpart.json", "new.thinpart.json"):
        shutil.copyfile(place / "library" / "plate.step.thinpart.json", place / "part.step.thinpart.json")
        if option not in ("-o", "--output") or command != "report" or (place / name).exists():
            for more in ((), ("--overwrite",)):
                assert refused(place, command, option, place / name, *more), name


@pytest.mark.parametrize("command, option, ending", [each for each in OUTPUTS if each[2]])
@pytest.mark.parametrize("cad", ENDINGS)
def test_no_output_has_the_name_of_a_cad_file(place, command, option, ending, cad):
    if cad != ending:
        assert refused(place, command, option, place / f"New{cad.upper()}", "--overwrite")


def test_a_document_in_a_folder_is_an_input_too(place, capsys):
    os.link(place / "library" / "plate.step", place / "table.csv")
    before = content_of(place)
    for command in ("classify", "size"):
        assert main([command, str(place / "library"), "--csv", "table.csv", "--overwrite"]) == 2
        assert "is an input of this run" in capsys.readouterr().err
    assert content_of(place) == before


def test_two_outputs_are_two_files(place, capsys):
    assert main(["size", "part.step", "--csv", "out.geo", "--geo", "./out.geo"]) == 2
    assert "named for two outputs" in capsys.readouterr().err and not (place / "out.geo").exists()


def test_a_place_that_cannot_be_written_is_told_before_anything_is_measured(place, capsys):
    assert main(["size", "part.step", "--csv", "no folder/out.csv"]) == 2
    said = capsys.readouterr()
    assert "no folder/out.csv cannot be written (No such file or directory)" in said.err and said.out == ""


WRITTEN = {
    "map": (["--pixels", "64x64"], {"--png": "out.png", "--vtp": "out.vtp", "--ply": "out.ply"}),
    "size": ([], {"--csv": "out.csv", "--geo": "out.geo", "--shell": "out.inp"}),
    "classify": (["--no-thumbnails"], {"--csv": "out.csv"}),
    "duplicates": ([], {"--csv": "out.csv"}),
}


@pytest.mark.parametrize("command", WRITTEN)
def test_what_thinpart_wrote_is_written_anew_and_what_it_did_not_write_where_the_user_says_so(place, command):
    more, options = WRITTEN[command]
    arguments = [command, "library" if command == "duplicates" else "part.step", *more,
                 *(each for pair in options.items() for each in pair)]
    outputs = [place / name for name in options.values()]
    for output in outputs:
        if output.suffix != ".ply":
            _foreign(output, None)
    run = thinpart(*arguments, "--overwrite", cwd=place)
    assert run.returncode == 0, run.stderr
    first = [output.read_bytes() for output in outputs]
    target = outputs[0].rename(place / f"target{outputs[0].suffix}")
    outputs[0].symlink_to(target.name)  # a link to a file of ThinPart's stays
    run = thinpart(*arguments, cwd=place)
    assert run.returncode == 0, run.stderr
    assert outputs[0].is_symlink() and [output.read_bytes() for output in outputs] == first


def test_what_is_written_there_is_all_that_is_not_written_below():
    tried = {(command, option, Path(name).suffix) for command, (_, options) in WRITTEN.items()
             for option, name in options.items()}
    assert {each for each in OUTPUTS if each[0] not in ("report", "learn")} - tried == {
        ("size", "--shell", ".msh"), ("size", "--shell", ".unv")}


@pytest.mark.parametrize("ending", SHELLS)
@pytest.mark.parametrize("label", ["plate", "a long label " * 100, "by ThinPart\n*INCLUDE, INPUT=x"])
def test_shells_of_every_format_and_label_are_written_anew(tmp_path, ending, label):
    shell = ShellMesh(np.eye(3), np.array([[0, 1, 2]]), np.array([0]), np.array([2.0]))
    path = tmp_path / f"shell{ending}"
    write_shell(path, shell, "another")
    write_shell(path, shell, label)
    write_shell(path, shell, "another")
    _foreign(path, None)
    with pytest.raises(ForeignFile, match="was not written by ThinPart"):
        write_shell(path, shell, label)


@pytest.mark.parametrize("ending, added", [(".inp", "*STEP\n"), (".msh", "$Periodic\n"), (".unv", "    -1\n")])
def test_a_shell_that_somebody_has_gone_on_with_is_not_written_anew(tmp_path, ending, added):
    shell = ShellMesh(np.eye(3), np.array([[0, 1, 2]]), np.array([0]), np.array([2.0]))
    path = tmp_path / f"shell{ending}"
    write_shell(path, shell, "plate")
    path.write_text(path.read_text() + added)
    with pytest.raises(ForeignFile, match="was not written by ThinPart"):
        write_shell(path, shell, "plate")
    assert path.read_text().endswith(added)
    write_shell(path, shell, "plate", overwrite=True)
    assert bears_mark(path, SHELLS[ending])


def test_a_script_that_somebody_has_gone_on_with_is_not_written_anew(tmp_path):
    path = tmp_path / "plate.geo"
    write_geo(path, 3.0, None)
    write_geo(path, 2.0, None)
    path.write_text(path.read_text() + 'Physical Volume("mine") = {1};\n')
    with pytest.raises(ForeignFile, match="was not written by ThinPart"):
        write_geo(path, 2.0, None)
    assert "mine" in path.read_text()


# What happens between the check and the writing

def test_a_file_that_another_program_writes_meanwhile_is_not_lost(tmp_path):
    path = tmp_path / "map.png"
    path.write_bytes(b"old")

    class Mark:
        """Takes every file for ThinPart's, and lets another program replace it then."""

        endings = ()

        def is_in(self, _):
            (tmp_path / "theirs").write_bytes(b"theirs")
            os.replace(tmp_path / "theirs", path)
            return True

    with pytest.raises(ForeignFile, match="by another program meanwhile"):
        write_output(path, b"ours", Mark())
    assert path.read_bytes() == b"theirs" and os.listdir(tmp_path) == ["map.png"]


@pytest.mark.parametrize("has_links", [True, False])
def test_a_new_file_never_takes_the_name_of_another(tmp_path, monkeypatch, has_links):
    def no_link(*_):
        raise PermissionError(1, "Operation not permitted")  # as on FAT

    if not has_links:
        monkeypatch.setattr(os, "link", no_link)
    for name, content in (("ours", b"ours"), ("theirs", b"theirs")):
        (tmp_path / name).write_bytes(content)
    with pytest.raises(FileExistsError):
        place_new(tmp_path / "ours", tmp_path / "theirs")
    assert (tmp_path / "theirs").read_bytes() == b"theirs"
    place_new(tmp_path / "ours", tmp_path / "new")
    assert (tmp_path / "new").read_bytes() == b"ours" and sorted(os.listdir(tmp_path)) == ["new", "theirs"]


def test_one_module_writes_outputs():
    # Others write info files, the cache, and a copy of a mended part under a free name.
    writers = {path.stem for path in PACKAGE.rglob("*.py") if "write_atomically" in path.read_text(encoding="utf-8")}
    assert writers <= {"atomic_file", "output_file", "info_file", "cache_folder", "mesh_sizes"}


# Reports

def test_a_report_replaces_its_own_files_alone(place):
    folder = place / "report"
    for _ in range(2):
        run = thinpart("report", "part.step", "-o", folder, cwd=place)
        assert run.returncode == 0, run.stderr
    files = sorted(path.name for path in folder.iterdir() if path.is_file())
    assert files == ["faces.csv", "index.html", "parts.csv", "thinpart-report.json"]
    for name in files:
        kept = (folder / name).read_bytes()
        (folder / name).write_bytes(b"mine")
        before = content_of(place)
        assert main(["report", "part.step", "-o", str(folder)]) == 2 and content_of(place) == before
        (folder / name).write_bytes(kept)


def test_a_page_about_a_library_replaces_its_own_files_alone(place):
    folder, arguments = place / "report", ["report", "--library", "library", "-o", "report"]
    for _ in range(2):
        assert main(arguments) == 0
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    assert [path.suffix for path in files] == [".html", ".png", ".json"]
    for file in files:
        kept = file.read_bytes()
        for make in (_foreign, *NEVER):
            file.unlink()
            make(file, place / "library" / "plate.step" if make is not _info_file else place / "part.step")
            before = bytes_of(place)
            assert main(arguments) == 2 and bytes_of(place) == before, make
            if make is not _foreign and (make is not _hard_link or file.suffix != ".png"):
                assert main([*arguments, "--overwrite"]) == 2 and bytes_of(place) == before, make
        file.unlink()
        file.write_bytes(kept)
    assert main(arguments) == 0


def test_pages_of_others_stay(tmp_path):
    pixels = np.zeros((PICTURE_HEIGHT, PICTURE_WIDTH, 4), np.uint8).tobytes()
    drawn = DrawnPart(page=b'<!DOCTYPE html><meta name="generator" content="ThinPart 1">',
                      picture=png_bytes(pixels, PICTURE_WIDTH, PICTURE_HEIGHT))
    pages = ReportPages(os.fspath(tmp_path), "part.step", "")
    page, picture = tmp_path / pages.page("Solid1"), tmp_path / pages.picture("Solid1")
    pages.write(drawn, {"name": "Solid1"})
    picture.write_bytes(drawn.picture[:33] + drawn.picture[33 + 12 + 17:])  # as earlier versions wrote it
    pages.write(drawn, {"name": "Solid1"})
    assert picture.read_bytes() == drawn.picture and page.read_bytes() == drawn.page
    for path in (page, picture):
        kept = path.read_bytes()
        path.write_bytes(b"mine")
        with pytest.raises(ThinPartError, match="was not written by ThinPart"):
            pages.write(drawn, {"name": "Solid1"})
        assert path.read_bytes() == b"mine"
        replace(pages, overwrite=True).write(drawn, {"name": "Solid1"})
        assert path.read_bytes() == kept


# Labels, which people write and change themselves

def test_labels_that_somebody_wrote_or_changed_are_not_replaced(place, capsys):
    written = place / "all.csv"
    export = ["learn", "library", "--labels", "labels.csv", "--export-labels", str(written)]
    assert main(export) == 0 and main(export) == 0
    rows = list(csv.reader(written.read_text().splitlines()))
    assert rows[0][:7] == ["file", "part", "category", "person", "sure", "second", "group"] and rows[1][2] == "thin"
    resaved = "\n".join(",".join(f'"{cell}"' for cell in [*row, *[""] * (len(rows[0]) - len(row))]) for row in rows)
    written.write_text(resaved)  # by a spreadsheet
    assert main(export) == 0
    changed = written.read_text().replace("thin,", "normal,", 1)
    for content in (changed, "file,part,category,person,sure,second,group\nplate.step,,thin,Anna,yes,,\n"):
        written.write_text(content)
        assert main(export) == 2 and written.read_text() == content
        assert "was not written by ThinPart" in capsys.readouterr().err
    assert main([*export, "--overwrite"]) == 0 and "thin" in written.read_text()
    # They are read as before.
    assert main(["learn", "library", "--labels", str(written), "--export-labels", str(place / "again.csv")]) == 0
    assert (place / "again.csv").read_bytes() == written.read_bytes()


# Files of earlier versions

@pytest.mark.parametrize("mark, content", [
    (TABLE, b"file,part,label,instances,category,criteria,margin\n"),
    (TABLE, b"file,part,label,face,made_by,area_mm2,thinnest_mm\n"),
    (MAPS[".vtp"], b'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" '
                   b'header_type="UInt32">\n<PolyData>\n<Piece NumberOfPoints="3" NumberOfPolys="1">\n'
                   b'<PointData Scalars="thickness_mm">\n'),
    (MAPS[".ply"], b"ply\nformat binary_little_endian 1.0\ncomment wall thickness in mm, by ThinPart\nelement vertex 3\n"),
    (PAGE, b'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
           b'<meta name="generator" content="ThinPart 0.1">'),
    (PROFILE, json.dumps({"version": 1, "format": "thinpart-profile"}).encode()),
    (LIMITS, b'{"format": "thinpart-wall-limits"}'), (REPORT, b'{"format": "thinpart-report"}'),
])
def test_what_earlier_versions_wrote_is_recognised(tmp_path, mark, content):
    for each, is_ours in ((content, True), (content[1:], False), (b"", False)):
        (tmp_path / "file").write_bytes(each)
        with open(tmp_path / "file", "rb") as file:
            assert mark.is_in(file) == is_ours


def test_a_picture_of_another_program_has_no_mark():
    with open(next(SCREENSHOTS.glob("*.png")), "rb") as file:
        assert not PICTURE.is_in(file)
