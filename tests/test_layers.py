"""The layers: gui and cli -> workflow -> freecad_adapter, storage -> core, system."""

import ast
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[1] / "thinpart_workbench"
FREECAD = {"FreeCAD", "App", "Part", "Mesh", "MeshPart", "Import", "PartDesign"}
QT = {"PySide", "PySide2", "PySide6", "shiboken2"}
GUI = {"FreeCADGui", "pivy"}

UNIX_OR_WINDOWS = {"fcntl", "resource", "pwd", "grp", "termios", "tty", "select", "msvcrt", "winreg"}
"""Modules that only some systems have, or that can do less on some."""

MAY_IMPORT = {
    "system": set(),
    "core": set(),
    "storage": {"core", "system"},
    "freecad_adapter": {"core", "system"},
    "workflow": {"core", "system", "storage", "freecad_adapter"},
    "cli": {"core", "system", "storage", "workflow", "freecad_adapter"},
    "gui": {"core", "system", "storage", "workflow", "freecad_adapter"},
}


def imports(path):
    """(layer of ours or '', top-level module) of every import in a file."""
    own_layer = path.relative_to(PACKAGE).parts[0]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            for name in node.names:
                yield "", name.name.split(".")[0]
        elif isinstance(node, ast.ImportFrom):
            if node.level == 0:
                yield "", node.module.split(".")[0]
            elif node.level == len(path.relative_to(PACKAGE).parts):
                for name in [node.module] if node.module else [n.name for n in node.names]:
                    yield name.split(".")[0], ""
            else:
                yield own_layer, ""


def files(layer):
    return sorted((PACKAGE / layer).rglob("*.py"))


@pytest.mark.parametrize("layer", MAY_IMPORT)
def test_a_layer_imports_only_what_lies_below(layer):
    assert files(layer)
    for path in files(layer):
        ours = {name for name, _ in imports(path) if name and (PACKAGE / name).is_dir()}
        assert ours <= MAY_IMPORT[layer] | {layer}, path


@pytest.mark.parametrize("layer", ["core", "storage"])
def test_core_and_storage_use_numpy_scipy_and_the_standard_library(layer):
    for path in files(layer):
        foreign = {module for _, module in imports(path) if module}
        assert foreign <= set(sys.stdlib_module_names) | {"numpy", "scipy"}, path


@pytest.mark.parametrize("layer", ["freecad_adapter", "workflow", "cli"])
def test_what_runs_without_a_window_never_imports_one(layer):
    for path in files(layer):
        assert not {module for _, module in imports(path)} & (QT | GUI), path


def test_what_systems_do_differently_stands_in_one_layer():
    allowed = {"contextlib", "ctypes", "fcntl", "json", "msvcrt", "os", "pathlib", "resource", "select", "signal",
               "functools", "subprocess", "sys", "threading", "time", ""}
    assert {module for path in files("system") for _, module in imports(path)} <= allowed
    for layer in set(MAY_IMPORT) - {"system"}:
        for path in files(layer):
            assert not {module for _, module in imports(path)} & UNIX_OR_WINDOWS, path


def test_freecad_is_known_to_the_adapter_alone_below_the_window():
    for layer in ("core", "storage", "workflow", "cli"):
        for path in files(layer):
            assert not {module for _, module in imports(path)} & FREECAD, path


def test_one_module_of_gui_imports_qt():
    assert [path.name for path in files("gui") if {m for _, m in imports(path)} & QT] == ["qt.py"]


MEASURING = (
    "columns", "surface_mesh", "edge_balance", "flat_regions", "smooth_normals", "mass_properties", "bounds",
    "box_refinement", "sampling", "box_tree", "ray_packets", "tree_descent", "ray_casting",
    "inward_rays", "thickness", "convex_clipping", "nonparallel", "slanted_pairs", "pair_rule",
    "distribution", "measurement", "face_thickness", "descriptors", "chord_error",
    "similarity", "camera", "rasterizer", "picture", "facet_refinement", "thickness_map", "map_summary",
    "map_search", "map_outline", "part_views",
)
JUDGING = ("criteria", "classification")


def _core_imports(name):
    path = PACKAGE / "core" / f"{name}.py"
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {node.module for node in ast.walk(tree)
            if isinstance(node, ast.ImportFrom) and node.level == 1}


def test_measuring_never_judges_and_judging_never_measures():
    for name in MEASURING:
        assert not _core_imports(name) & set(JUDGING), name
    for name in JUDGING:
        assert not _core_imports(name) & set(MEASURING) - {"descriptors"}, name


def _imported_at_once(path, package):
    """Dotted names of the modules that a file imports when it is imported itself."""
    waiting = list(ast.parse(path.read_text(encoding="utf-8")).body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import):
            yield from (name.name for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = ".".join(package[:len(package) - node.level + 1]) if node.level else ""
            module = ".".join(filter(None, (base, node.module)))
            yield module
            yield from (f"{module}.{name.name}" for name in node.names)
        elif not isinstance(node, (ast.FunctionDef, ast.Lambda)):
            waiting += list(ast.iter_child_nodes(node))


def test_freecad_starts_without_numpy():
    root, foreign, seen = PACKAGE.parent, set(), set()
    waiting = list(_imported_at_once(root / "InitGui.py", ()))
    while waiting:
        name = waiting.pop()
        path = root / Path(*name.split("."))
        file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
        if not file.is_file():
            foreign.add(name.split(".")[0])
        elif file not in seen:
            seen.add(file)
            parts = tuple(name.split("."))
            waiting += _imported_at_once(file, parts if path.is_dir() else parts[:-1])
    assert PACKAGE / "gui" / "automatic_classification.py" in seen
    assert not foreign & {"numpy", "scipy", "pebble"}
