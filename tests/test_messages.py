# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the layers below the window say is made as messages, so that the window can say it in another language."""

import ast
import string
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "thinpart_workbench"
sys.path.insert(0, str(ROOT / "resources" / "translations"))

import texts_of_code  # noqa: E402

NOT_SHOWN = {
    "freecad_adapter/preferences.py", "workflow/cluster/cluster_run.py", "workflow/cluster/cluster_worker.py",
    "workflow/cluster/cluster_answer.py", "workflow/cluster/analysis_server.py", "workflow/cluster/plain_pickles.py",
    "core/kinds/value_kinds.py", "core/kinds/compound_kinds.py", "core/kinds/value_checker.py",
    "core/kinds/typed_kinds.py",
    "core/record/record_types.py", "core/descriptors/descriptor_types.py", "storage/info/info_definition.py",
    # for programs and the command line
    "freecad_adapter/reading/held_parts.py", "workflow/library/library_search.py", "storage/index/written_query.py",
    "api/classification.py", "api/found_parts.py", "api/libraries.py", "api/mesh_arrays.py",
    "workflow/meshing/size_steps.py",
    "core/kinds/file_marks.py", "storage/exchange/geo_file.py", "storage/exchange/map_export.py",
    "storage/exchange/shell_files.py",  # what other programs read
    "workflow/meshing/size_result.py",  # as what is wrong within an info file
}
"""No sentence of these comes to the window: it starts no cluster, and reads no meanings of preferences. What is wrong
within an info file stands in parentheses, in English, as what Python says about JSON does."""

NO_MESSAGES = {
    "unknown kind of failure: {}",  # for programmers
    "the pool takes no tasks any more",
    "the part has gone from the index since it was found",
    "a message of {} bytes",  # of a worker that has gone wrong: it is replaced, and nobody is told this
    "There is no home folder",  # in what Python says of an OSError
    "surface (\\d+)",  # what Gmsh prints
    "Wall thickness", "not measured",  # translated where FreeCAD asks for them
    "share of the diagonal", "red is thin",  # FreeCAD's property editor, which translates nothing; documents keep it
    "Made by ThinPart", "Settings of the element sizes by ThinPart",  # likewise
    "Settings of the shell by ThinPart", "What this is the mid-surface of",
    "User parameter:BaseApp/Preferences/Mod/Fem/Gmsh",
    "The content of <{}> cannot be escaped: it comes from a file of ThinPart.",  # for programmers
    " ThinPart {}.", "default-src 'none'; style-src 'unsafe-inline'; img-src data:",  # of pages, as their classes
    "dot failed", "faint path", "faint small", "faint small path", "noprint small", "path small", "small faint",
    "small faint path", "small noprint", "small faint noprint", "search noprint", "badge keep", "group even",
    "thinpart duplicates",  # a command, as it is typed
}
"""What looks like a text for people and is none, or is shown as it is."""

BELOW = [path for layer in ("core", "storage", "freecad_adapter", "workflow", "api", "window_processes")
         for path in sorted((PACKAGE / layer).rglob("*.py")) if path.relative_to(PACKAGE).as_posix() not in NOT_SHOWN]
COMMANDS = [PACKAGE / "cli" / name for name in ("commands/classify.py", "commands/report.py", "run_options.py")]
"""Those that the window starts: their refusals are shown there."""


def name_of(path):
    return path.relative_to(PACKAGE).as_posix()


def said_plainly(tree):
    """Texts for people that are no messages, tables of texts aside."""
    return texts_of_code.prose(tree) - NO_MESSAGES


@pytest.mark.parametrize("path", BELOW, ids=name_of)
def test_what_people_read_is_a_message(path):
    tree = texts_of_code.tree_of(path)
    tables = set().union(*(texts_of_code.table_texts(*each) for each in texts_of_code.TABLES
                           if each[0] == name_of(path)))
    assert said_plainly(tree) - tables == set(), "make it with core.message.message"


@cache
def errors():
    """Names of `ThinPartError` and of all classes that are made of it."""
    names = {"ThinPartError"}
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(texts_of_code.tree_of(path)):
            if isinstance(node, ast.ClassDef) and names & {getattr(base, "id", "") for base in node.bases}:
                names.add(node.name)
    return names


def plain_errors(tree, names):
    """Lines where an error is made with a text that is no message."""
    return [call.lineno for call in texts_of_code.calls(tree, names)
            if call.args and isinstance(call.args[0], (ast.Constant, ast.JoinedStr, ast.BinOp))]


@pytest.mark.parametrize("path", BELOW + COMMANDS, ids=name_of)
def test_errors_are_made_with_messages(path):
    assert {"ThinPartError", "MeshError", "ProfileError", "DamagedInfoFile"} <= errors()
    assert plain_errors(texts_of_code.tree_of(path), errors()) == [], "make it with core.message.message"


@pytest.mark.parametrize("code", [
    'raise ThinPartError(f"{name} is broken.", "failed")', 'raise ThinPartError("It is broken.")',
    'raise MeshError("It " + what)'])
def test_an_error_with_a_plain_text_is_found(code):
    assert plain_errors(ast.parse(code), {"ThinPartError", "MeshError"}) == [1]


@pytest.mark.parametrize("code", [
    'warnings.append(f"{count} triangles were left out.")', 'warnings = ["The surface is open."]',
    'say(failure=f"{name} took too long.")', 'message("{a}", a=f"{name} took too long.")'])
def test_a_sentence_that_is_no_message_is_found(code):
    assert said_plainly(ast.parse(code))


def test_a_message_is_none_of_these():
    code = 'raise ThinPartError(message("{file} is broken.", file=name), "failed")'
    assert not said_plainly(ast.parse(code)) and not plain_errors(ast.parse(code), {"ThinPartError"})


@pytest.mark.parametrize("code", ['message(text)', 'message(f"{name} is broken.")', 'message("a" + b)'])
def test_a_template_is_a_literal(code, tmp_path):
    (tmp_path / "module.py").write_text(code)
    with pytest.raises(ValueError, match="module.py, line 1"):
        list(texts_of_code.templates(tmp_path / "module.py"))


@pytest.mark.parametrize("path", [path for layer in texts_of_code.LAYERS_BELOW
                                  for path in sorted((PACKAGE / layer).rglob("*.py"))], ids=name_of)
def test_messages_have_the_fields_of_their_templates(path):
    for call in texts_of_code.calls(texts_of_code.tree_of(path), ("message",)):
        fields = {name for _, name, _, _ in string.Formatter().parse(call.args[0].value) if name is not None}
        assert fields == {each.arg for each in call.keywords}, f"line {call.lineno}"
