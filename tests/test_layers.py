# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers: gui, window_processes and cli -> api -> workflow -> freecad_adapter, storage -> core, system."""

import ast
import re
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
    "api": {"core", "system", "storage", "workflow", "freecad_adapter"},
    # `workflow` by way of `api` alone:
    "cli": {"core", "system", "storage", "freecad_adapter", "api"},
    "window_processes": {"core", "system", "storage", "freecad_adapter", "api"},
    "gui": {"core", "system", "storage", "freecad_adapter", "api"},
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


@pytest.mark.parametrize("layer", ["freecad_adapter", "workflow", "api", "cli", "window_processes"])
def test_what_runs_without_a_window_never_imports_one(layer):
    for path in files(layer):
        assert not {module for _, module in imports(path)} & (QT | GUI), path


def test_what_systems_do_differently_stands_in_one_layer():
    allowed = {"contextlib", "ctypes", "dataclasses", "enum", "errno", "fcntl", "functools", "getpass", "json", "msvcrt",
               "os", "pathlib", "platform", "resource", "select", "shutil", "signal", "struct", "subprocess", "sys",
               "threading", "time", ""}
    assert {module for path in files("system") for _, module in imports(path)} <= allowed
    for layer in set(MAY_IMPORT) - {"system"}:
        for path in files(layer):
            assert not {module for _, module in imports(path)} & UNIX_OR_WINDOWS, path


def test_only_learning_asks_for_more_than_a_bundle_of_freecad_has():
    # So its tests alone run in a Python without that too. Importing the list would hide them here.
    bundle = ast.parse((Path(__file__).parent / "bare_python" / "sitecustomize.py").read_text(encoding="utf-8"))
    hidden, = [ast.literal_eval(each.value) for each in bundle.body
               if isinstance(each, ast.Assign) and ast.unparse(each.targets[0]) == "HIDDEN"]
    asking = {path.stem: module for layer in MAY_IMPORT for path in files(layer) for _, module in imports(path)
              if module in hidden}
    assert asking == {"fit_probabilities": "sklearn"}


def test_the_network_is_reached_as_the_document_on_security_says():
    network = {"asyncio", "distributed", "ftplib", "http", "requests", "smtplib", "socket", "socketserver", "ssl", "urllib3",
               "webbrowser", "xmlrpc"}
    everything = sorted(PACKAGE.rglob("*.py"))
    assert {path.stem for path in everything if {module for _, module in imports(path)} & network} == {
        "cluster_run", "cluster_worker"}  # of classify --dask
    addresses = {path: path.read_text(encoding="utf-8") for path in everything}
    assert not [path for path, text in addresses.items() if re.search(r"urllib\.request|urlopen|QtNetwork|WebEngine", text)]
    # Files and folders of this machine aside: a link in the guide, and the link of a part, which is confirmed.
    opening = re.compile(r"openUrl\((?!QtCore\.QUrl\.fromLocalFile)")
    assert {path.stem for path, text in addresses.items() if opening.search(text)} == {"window", "notes_page"}


def test_freecad_is_known_to_the_adapter_alone_below_the_window():
    for layer in ("core", "storage", "workflow", "api", "cli", "window_processes"):
        for path in files(layer):
            assert not {module for _, module in imports(path)} & FREECAD, path


def test_one_module_of_gui_imports_qt():
    assert [path.name for path in files("gui") if {m for _, m in imports(path)} & QT] == ["qt.py"]


PACKAGE_ORDER = {
    "core": "kinds mesh rays descriptors walls forms thickness record sizing shells judging reuse risk maps rendering",
    "storage": "exchange info index",
    "freecad_adapter": "tessellating exact_walls shapes mid_surface reading occurrences features objects",
    "workflow": "report analysis workers cluster library reuse meshing solving maps learning",
    "api": "window report",
    "cli": "commands",
    "gui": "application widgets tables guide processes record document scene colour_bar section view3d map_export "
           "map_presenters classify thickness mesh_sizes reclassify report library folder profile learning preferences "
           "on_save",
}
"""The packages of each layer: each imports only those before it, and modules that lie in the layer itself, not in a package.

Modules of the layer itself may lie below the packages, as in core, or above, as in gui, where `start` puts all together;
they are held by the search for circles among packages.
"""

MOST_MODULES = 18
"""Modules of one package: those that one can look through at a glance."""


def _package_edges(layer):
    """{package: {packages that its modules import, be it within functions}}; "" is the layer itself."""
    modules = _modules(PACKAGE)
    inside = f"{PACKAGE.name}.{layer}."
    edges = {}
    for name, file in modules.items():
        if name.startswith(inside) and name not in OLD_NAMES:
            own = edges.setdefault(_package(name, file, layer), set())
            for imported in _imported_anywhere(name, file, modules):
                if imported.startswith(inside):
                    own.add(_package(imported, modules[imported], layer))
    return {package: others - {package} for package, others in edges.items()}


def _package(name, file, layer):
    parts = name.split(".") if file.name == "__init__.py" else name.split(".")[:-1]
    return ".".join(parts[2:])


@pytest.mark.parametrize("layer", PACKAGE_ORDER)
def test_packages_are_those_that_are_listed_and_import_only_those_before_them(layer):
    order = PACKAGE_ORDER[layer].split()
    edges = _package_edges(layer)
    assert sorted(order) == sorted(set(edges) - {""})
    for number, package in enumerate(order):
        assert edges[package] - {""} <= set(order[:number]), package


@pytest.mark.parametrize("layer", [*PACKAGE_ORDER, "system", "window_processes"])
def test_no_two_packages_of_a_layer_import_each_other(layer):
    edges = _package_edges(layer)
    assert not [(one, other) for one in edges for other in edges[one] if one in edges[other]]


def test_packages_can_be_looked_through():
    folders = [PACKAGE / layer for layer in MAY_IMPORT]
    folders += [path.parent for folder in folders for path in folder.rglob("*/__init__.py") if path.parent != folder]
    assert len(folders) > 30
    for folder in folders:
        modules = {path.stem for path in folder.glob("*.py")} - {"__init__"}
        assert len(modules) <= MOST_MODULES, folder


def _core_imports(folder):
    """Packages of core that the modules of another one import."""
    return _package_edges("core")[folder]


def test_measuring_never_judges_and_judging_never_measures():
    for package in ("mesh", "rays", "descriptors", "forms", "thickness", "maps", "rendering"):
        assert "judging" not in _core_imports(package), package
    assert _core_imports("judging") <= {"", "descriptors", "kinds", "record"}
    measuring = {"measurement", "thickness_field", "nonparallel", "pair_rule"}
    for path in files("core/judging"):
        assert not {name.rpartition(".")[2] for name in _imported_anywhere(
            f"{PACKAGE.name}.core.judging.{path.stem}", path, _modules(PACKAGE))} & measuring, path


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
        elif isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            waiting += node.orelse
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
    assert PACKAGE / "gui" / "on_save" / "auto_classifier.py" in seen
    assert not foreign & {"numpy", "scipy"}


def _modules(package):
    """Files of all modules of a package, by their dotted names."""
    found = {}
    for file in sorted(package.rglob("*.py")):
        parts = file.relative_to(package.parent).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = file
    return found


def _imported_anywhere(name, file, modules):
    """Modules of ours that a module imports, be it within a function."""
    parts = name.split(".")
    package = parts if file.name == "__init__.py" else parts[:-1]
    found = set()
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[:len(package) - node.level + 1] if node.level else []
            module = ".".join([*base, *filter(None, [node.module])])
            inner = {f"{module}.{each.name}" for each in node.names}
            found |= inner & set(modules) or {module}
    return found & set(modules) - {name}


def test_modules_that_are_imported_exist():
    """Also within functions, which run late: the type checker does not read the window's modules."""
    modules = _modules(PACKAGE)
    missing = []
    for name, file in modules.items():
        package = name.split(".") if file.name == "__init__.py" else name.split(".")[:-1]
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level:
                imported = ".".join([*package[:len(package) - node.level + 1], *filter(None, [node.module])])
                missing += [f"{name}:{node.lineno}: {imported}"] if imported not in modules else []
    assert len(modules) > 300 and missing == []


def circles(package):
    """The shortest ways from every module back to itself, as "a -> b -> a"; each of them once."""
    modules = _modules(package)
    imported = {name: _imported_anywhere(name, file, modules) for name, file in modules.items()}
    ways = {}
    for start in imported:
        waiting, seen = [(start,)], {start}
        while waiting:
            way = waiting.pop(0)
            if start in imported[way[-1]]:
                ways.setdefault(frozenset(way), " -> ".join([*way, start]))
                break
            more = sorted(imported[way[-1]] - seen)
            seen |= set(more)
            waiting += [(*way, each) for each in more]
    return sorted(ways.values())


def test_no_module_imports_itself_by_way_of_others():
    found = circles(PACKAGE)
    assert not found, "\n".join(["import circles:", *found])


def test_circles_are_found_wherever_they_are_closed(tmp_path):
    package = tmp_path / "example"
    (package / "inner").mkdir(parents=True)
    for name, text in {
            "__init__": "", "inner/__init__": "", "a": "from .inner import b", "c": "import example.a",
            "inner/b": "def late():\n    from ..c import d", "alone": "from . import a"}.items():
        (package / f"{name}.py").write_text(text)
    assert circles(package) == ["example.a -> example.inner.b -> example.c -> example.a"]


MADE_AT_IMPORT = {
    "Path", "Path.resolve", "?.as_posix", "tuple", "list", "range", "namedtuple", "re.compile", "np.radians",
    "__name__.partition", "translate", "LengthUnit", "QtGui.QColor", "QtCore.QModelIndex", "Signal", "dataclass",
    "guarded_methods", "lru_cache", "Command", "QT_TRANSLATE_NOOP",
}
"""What a module of gui may call when it is imported: what gives values, and what declares classes and functions."""


def _called(node):
    """Name of what a call calls: ``Path(...).resolve()`` is Path.resolve."""
    if isinstance(node, ast.Call):
        return _called(node.func).partition(".")[0]
    if isinstance(node, ast.Subscript):
        return _called(node.value)
    if isinstance(node, ast.Attribute):
        return f"{_called(node.value)}.{node.attr}"
    return getattr(node, "id", "?")


def _done_at_import(tree):
    """Names of what a module calls when it is imported, in its classes too; of loops, the word."""
    waiting = list(tree.body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, (ast.For, ast.While, ast.With)):
            yield type(node).__name__
        if isinstance(node, (ast.FunctionDef, ast.Lambda)):
            waiting += [*getattr(node, "decorator_list", ()), *node.args.defaults, *filter(None, node.args.kw_defaults)]
            continue
        if isinstance(node, ast.Call):
            yield _called(node.func)
        waiting += list(ast.iter_child_nodes(node))


def test_importing_a_module_of_the_window_makes_nothing():
    for path in set(files("gui")) - {PACKAGE / "gui" / "activate_workbench.py"}:  # which is a script
        assert set(_done_at_import(ast.parse(path.read_text(encoding="utf-8")))) <= MADE_AT_IMPORT, path


def test_what_lives_as_long_as_freecad_is_made_by_the_start_alone():
    for path in files("gui"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        made = {ast.unparse(node) for node in ast.walk(tree)
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store)
                and isinstance(node.value, ast.Name) and node.value.id == "lifelong"}
        assert not made or path.name == "start.py", path
    assert set(imports(PACKAGE / "gui" / "application" / "lifelong.py")) == set(), "so that anything may import it"


@pytest.mark.parametrize("layer", ["gui", "window_processes", "cli"])
def test_the_window_and_the_command_line_have_their_work_done_by_api_alone(layer):
    modules, below = _modules(PACKAGE), f"{PACKAGE.name}.workflow"
    for path in files(layer):
        name = ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
        assert not [each for each in _imported_anywhere(name, path, modules) if each.startswith(below)], path
        assert below not in path.read_text(encoding="utf-8"), "nor does it start a process of workflow"


FOR_GUI = {
    "core": {
        # values and words that every layer shares
        "errors", "message", "figures", "number_text", "length_unit", "categories", "problem", "hook", "foreign_text",
        "file_formats", "kinds.file_marks", "rigid_transform", "descriptors", "judging.limit_bands",
        "judging.condition_text",
        # settings and their defaults; a profile is one
        "analysis_settings", "analysis_limits", "judging.criteria", "sizing.sizing_settings", "shells.shell_settings",
        # what is drawn
        "maps", "rendering", "mesh.thinned_facets", "mesh.tetrahedra", "rays.line_of_sight",
    },
    "freecad_adapter": {
        "preferences", "guard", "objects", "occurrence", "occurrences",  # and what starts other programs:
        "additional_packages", "python_beside_freecad",
    },
}
"""What gui imports beside `api`, which judges, measures, sums up, searches, reads and compares for it."""


@pytest.mark.parametrize("layer", FOR_GUI)
def test_the_window_has_domain_work_done_by_api(layer):
    modules, inside = _modules(PACKAGE), f"{PACKAGE.name}.{layer}."
    for path in files("gui"):
        name = ".".join(path.relative_to(PACKAGE.parent).with_suffix("").parts)
        below = {each[len(inside):] for each in _imported_anywhere(name, path, modules) if each.startswith(inside)}
        allowed = tuple(f"{each}." for each in FOR_GUI[layer])
        assert not [each for each in below if not f"{each}.".startswith(allowed)], path


IN_SAVED_DOCUMENTS = {
    "gui.thickness_view": "ThicknessView",
    "freecad_adapter.thickness_object": "ThicknessObject",
    "freecad_adapter.wall_measurement": "WallMeasurement",
}
"""Classes that documents of earlier versions name by their module; one that moves leaves its name behind there."""

OLD_NAMES = {f"{PACKAGE.name}.{name}" for name in IN_SAVED_DOCUMENTS}


@pytest.mark.parametrize("module", IN_SAVED_DOCUMENTS)
def test_classes_are_where_saved_documents_name_them(module):
    tree = ast.parse((PACKAGE / Path(*module.split("."))).with_suffix(".py").read_text(encoding="utf-8"))
    there = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    there |= {name.asname or name.name for node in tree.body if isinstance(node, ast.ImportFrom) for name in node.names}
    assert IN_SAVED_DOCUMENTS[module] in there


def test_every_command_opens_something_of_a_module():
    """COMMANDS names what each opens, so that no import shows it."""
    named = re.findall(r'"([a-z_.]+):(\w+)"', (PACKAGE / "gui" / "commands.py").read_text(encoding="utf-8"))
    assert len(named) >= 11
    for module, name in named:
        tree = ast.parse((PACKAGE / "gui" / Path(*module.split("."))).with_suffix(".py").read_text(encoding="utf-8"))
        assert name in {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}, module


def test_every_process_of_the_window_is_a_module():
    named = {text for path in files("gui") for text in re.findall(r'"([a-z_]+_worker)"', path.read_text(encoding="utf-8"))}
    assert len(named) >= 3
    for name in named:
        assert (PACKAGE / "window_processes" / f"{name}.py").is_file(), name


def test_every_function_that_the_window_has_called_is_one_of_api():
    named = {text for path in files("gui")
             for text in re.findall(r'"([a-z_]+\.[a-z_]+)"', path.read_text(encoding="utf-8"))}
    requests = {text for text in named if (PACKAGE / "api" / f"{text.partition('.')[0]}.py").is_file()}
    assert len(requests) >= 6
    for module, name in (text.split(".") for text in requests):
        tree = ast.parse((PACKAGE / "api" / f"{module}.py").read_text(encoding="utf-8"))
        assert name in {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}, f"{module}.{name}"
