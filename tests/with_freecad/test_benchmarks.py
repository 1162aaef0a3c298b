# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark runs and writes what it says; how fast anything is, is not tested."""

import json
import os
import shutil
import subprocess
import sys

import pytest
from program import ROOT, SAMPLES

from benchmarks.meshing_tables import meshing_target_tables
from benchmarks.tables import stored, with_tables
from thinpart_workbench.core.analysis_settings import ACCURACIES, AnalysisSettings

QUICKEST = ("--only", "rays", "cores", "--solids", "shell", "--sizes", "1000", "--repeat", "1")


def benchmark(*arguments, cache, command="run"):
    environment = dict(os.environ, THINPART_CACHE=str(cache))
    return subprocess.run(
        [sys.executable, ROOT / "benchmarks" / f"{command}.py", *map(str, arguments)], env=environment,
        capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL,
    )


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("benchmark")
    run = benchmark(*QUICKEST, "-o", folder / "results.json", cache=folder)
    assert run.returncode == 0, run.stderr
    run.file = folder / "results.json"
    run.results = json.loads(run.file.read_text(encoding="utf-8"))
    return run


def test_every_figure_of_both_placements_is_there(run):
    aligned, rotated = run.results["meshes"]
    assert (aligned["placement"], rotated["placement"]) == ("aligned", "rotated")
    for row in (aligned, rotated):
        assert row["failures"] == {}
        assert 700 < row["triangles"] < 1400
        assert {"tessellation", "core", "whole", "box", "nonparallel"} <= row["seconds"].keys()
        assert all(0.0 < seconds < 100.0 for times in row["seconds"].values() for seconds in times)
        assert row["found"]["whole"]["samples"] >= AnalysisSettings.minimum_samples
        assert row["found"]["box"]["volume"] == pytest.approx(40.0 ** 3, rel=0.03)
        assert 0.0 <= row["bytes_per_triangle"]["core"] < row["bytes_per_triangle"]["whole"]
    assert {"core_on_1", "core_on_2", "whole_on_1", "whole_on_2"} <= aligned["seconds"].keys()
    # The same triangles, turned.
    assert aligned["triangles"] == rotated["triangles"]


def test_machine_versions_and_date_are_there(run):
    assert {"cpu", "cores", "memory_gb", "os"} <= run.results["machine"].keys()
    assert {"ThinPart", "Python", "numpy", "scipy", "FreeCAD", "OCCT"} <= run.results["versions"].keys()
    assert run.results["date"].startswith("20")


@pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")
def test_parts_chosen_by_their_number_are_meshed_in_each_way(tmp_path):
    import Part

    for name, shape in (("t003_plate.brep", Part.makeBox(60, 40, 2)), ("t007_block.brep", Part.makeBox(30, 25, 20)),
                        ("t004_plate.brep", Part.makeBox(60, 40, 2)), ("t013_sheet.brep", Part.makeBox(90, 40, 2))):
        shape.exportBrep(str(tmp_path / name))
    (tmp_path / "manifest.csv").write_text("file,expert_label\nt003_plate.brep,thin\nt007_block.brep,normal\n"
                                           "t004_plate.brep,thin\nt013_sheet.brep,thin_features\n")
    output = tmp_path / "results.json"
    run = benchmark(tmp_path, "--parts", 1, "--without-netgen", "-o", output, cache=tmp_path, command="meshing_peers")
    assert run.returncode == 0, run.stderr
    results = json.loads(output.read_text(encoding="utf-8"))
    thin, normal = results["meshing"]["parts"]
    assert (thin["group"], thin["category"], normal["group"], normal["category"]) == ("thin", "thin", "normal", "normal")
    meshes = thin["meshes"]
    assert meshes["ThinPart"]["layers_share"] > 0.9 > meshes["one size"]["layers_share"]
    assert meshes["equal"]["elements"] == pytest.approx(meshes["ThinPart"]["elements"], rel=0.35)
    assert meshes["curvature"]["elements"] > 0 and meshes["Netgen 2"]["reason"] == "Netgen is missing"
    assert normal["meshes"]["ThinPart"]["elements"] == normal["meshes"]["one size"]["elements"]
    assert (thin["family"], normal["family"]) == ("plate", "no sizes of its own")
    # All of the plate has the least size: so many elements has a uniform mesh of it.
    assert thin["uniform_elements"] == pytest.approx(meshes["ThinPart"]["elements"], rel=0.05)
    assert "t003" not in output.read_text(encoding="utf-8")
    assert "parts that ThinPart calls normal, whose mesh is as it was" in "".join(
        row[0] for table in meshing_target_tables(results) for row in table.rows)
    again = benchmark(tmp_path, "--parts", 1, "--without-netgen", "--kept", "-o", output, cache=tmp_path,
                      command="meshing_peers")
    assert again.returncode == 0 and json.loads(output.read_text(encoding="utf-8"))["meshing"] == results["meshing"]
    assert "ThinPart's sizes" in again.stdout


@pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")
def test_the_meshing_study_has_a_row_for_each_category_and_family_and_a_plot_of_every_part(tmp_path):
    import xml.etree.ElementTree as ElementTree

    import Part

    folder, records, plot = tmp_path / "parts", tmp_path / "records.json", tmp_path / "plot.svg"
    folder.mkdir()
    Part.makeBox(30, 20, 2).exportBrep(str(folder / "plate.brep"))
    Part.makeBox(30, 20, 25).exportBrep(str(folder / "block.brep"))
    run = benchmark(folder, "--json", records, "--plot", plot, "--jobs", 1, cache=tmp_path, command="meshing_study")
    assert run.returncode == 0, run.stderr
    parts = json.loads(records.read_text(encoding="utf-8"))
    rows = {line.split(" | ")[0].strip("| "): line for line in run.stdout.splitlines() if line.startswith("| ")}
    assert {part["category"] for part in parts} | {"plate", "no sizes of its own", "category", "family"} <= set(rows)
    drawing = ElementTree.parse(plot).getroot()
    circles = [each for each in drawing.iter("{http://www.w3.org/2000/svg}circle") if each.get("r") == "3"]
    assert len(circles) >= 2 * len(parts) == 4  # before and after, of each
    again = benchmark("--of", records, "--plot", tmp_path / "again.svg", cache=tmp_path, command="meshing_study")
    assert again.stdout == run.stdout and (tmp_path / "again.svg").read_bytes() == plot.read_bytes()
    assert benchmark(cache=tmp_path, command="meshing_study").returncode == 2


def test_nothing_names_a_folder_of_this_machine(run):
    text = run.file.read_text(encoding="utf-8")
    assert str(ROOT) not in text and str(run.file.parent) not in text


def test_what_was_not_measured_is_said_not_to_be(run):
    verdicts = {line["what"]: line["verdict"] for line in run.results["summary"]}
    assert verdicts["rotated / axis-aligned, worst"] != "not measured"
    assert verdicts["core / trimesh with embreex, geometric mean"] == "not measured"
    assert verdicts["one small part, command line, s"] == "not measured"
    assert "not measured" in run.stdout and "shell" in run.stdout


def test_results_are_shown_again_as_markdown(run):
    shown = benchmark(run.file, "--markdown", cache=run.file.parent, command="tables")
    assert shown.returncode == 0, shown.stderr
    assert "\n| triangles, about | core s |" in shown.stdout and "\n| 1,000 |" in shown.stdout


def test_a_document_takes_the_tables_that_were_measured_and_keeps_the_others(run):
    document = ("Before.\n\n<!-- benchmark rays: none -->\nold\n<!-- end of benchmark -->\n\nBetween.\n\n"
                "<!-- benchmark accuracy: none -->\nold\n<!-- end of benchmark -->\n")
    text = with_tables(document, run.file)
    assert text.startswith("Before.\n\n<!-- benchmark rays: results.json -->\n\n| triangles, about | core s |")
    assert "\n| 1,000 | " in text and "old" not in text
    assert text.endswith("Between.\n\n<!-- benchmark accuracy: none -->\n\n"
                         "Not measured yet: `python3 benchmarks/run.py`.\n\n<!-- end of benchmark -->\n")
    assert with_tables(text, run.file) == text


def test_a_wrong_file_is_one_sentence(tmp_path):
    (tmp_path / "other.json").write_text("{}", encoding="utf-8")
    shown = benchmark(tmp_path / "other.json", cache=tmp_path, command="tables")
    assert shown.returncode == 1
    assert shown.stderr.count("\n") == 1 and "no results file" in shown.stderr


@pytest.fixture(scope="module")
def whole_processes(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    parts = folder / "parts"
    (parts / "below").mkdir(parents=True)
    shutil.copy(SAMPLES / "plate.FCStd", parts)
    shutil.copy(SAMPLES / "block.step", parts / "below" / "block.STP")
    (parts / "below" / "broken.step").write_text("nothing", encoding="utf-8")
    run = benchmark("--quick", "--only", "verdicts", "--repeat", 1, "--parts", parts, "-o", folder / "results.json",
                    cache=folder)
    assert run.returncode == 0, run.stderr
    return stored(folder / "results.json")


@pytest.mark.timeout(180)  # starts the program eight times, and FreeCAD beside it
def test_the_program_and_a_bare_process_take_turns_on_the_same_files(whole_processes):
    small, made, real = whole_processes["verdicts"]
    assert (small["files"], real["files"]) == (1, 3)
    for each in (small, made, real):
        assert {"bare", "one_core", "two_cores"} <= each["seconds"].keys()
        assert all(0.0 < seconds < 600.0 for times in each["seconds"].values() for seconds in times)
        assert 0.0 < sum(each["stages"].values()) < each["seconds"]["one_core"][0]
    assert len(small["seconds"]["table"]) == 1
    # The bare process has finer facets; what nobody can read is one failed file.
    assert 0 < made["own_triangles"] < made["triangles"]
    assert real["failed"] == {"bare": 1, "one_core": 1} and made["failed"] == {"bare": 0, "one_core": 0}
    assert [group["group"] for group in made["groups"] if group["by"] == "format"] == ["BREP", "FCStd", "IGES", "STEP"]
    formats = {group["group"]: group["files"] for group in real["groups"] if group["by"] == "format"}
    assert formats == {"FCStd": 1, "STEP": 1}
    targets = {line["what"]: line["got"] for line in whole_processes["summary"]}
    assert targets["time to a verdict / reading and tessellating, real parts"] == pytest.approx(
        real["seconds"]["one_core"][0] / real["seconds"]["bare"][0])


def test_results_name_no_real_part(whole_processes):
    assert "block.STP" not in json.dumps(whole_processes)


@pytest.mark.timeout(120)  # the reference is fine
def test_accuracy_compares_the_samples_with_a_finer_reference_and_keeps_it(tmp_path):
    arguments = ("--quick", "--reference", tmp_path / "reference", "--jobs", 2, "-o", tmp_path / "results.json")
    first, second = (benchmark(*arguments, cache=tmp_path, command="accuracy") for _ in range(2))
    assert first.returncode == second.returncode == 0, first.stderr + second.stderr
    every = stored(tmp_path / "results.json")["accuracy"]
    assert [(each["folder"], each["level"]) for each in every] == [("samples", accuracy) for accuracy in ACCURACIES]
    found, = (each for each in every if each["is_default"])
    assert (found["parts"], found["only_one_measured"]) == (3, 0)
    # Of the second run: everything was in the info files of the first.
    assert found["reference_seconds"] is None and len(list((tmp_path / "reference").rglob("*.json"))) == 3
    assert found["verdicts"]["calibrated"] == {"differ": 0, "borderline": 0}
    rows = {row["name"]: row for row in found["quantities"]}
    assert {"F[0;0.05]", "F[0;0.25]", "F[0.05;0.29]", "F[0.3;0.7]", "K[0;0.12]", "K[0;0.08]", "P[0;0.05]", "plate_ratio",
            "thinnest wall", "V", "V/VBB"} <= rows.keys()
    assert {rows[name]["stated"]["parts"] for name in ("F[0;0.05]", "K[0;0.12]", "V")} == {3}
    # Two parts are flat, on which both are exact; a taper makes some difference.
    assert 0.0 < rows["F[0;0.25]"]["greatest"] < 0.005
    assert rows["thinnest wall"]["stated"]["parts"] == 3
    assert "| quantity |" in benchmark(tmp_path / "results.json", "--markdown", cache=tmp_path, command="tables").stdout
